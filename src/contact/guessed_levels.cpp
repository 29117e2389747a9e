// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/guessed_levels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "geometry/brep/outline.hpp"
#include "src/base/index.hpp"
#include "src/contact/candidates.hpp"
#include "src/io/number_text.hpp"
#include "src/results/result_units.hpp"
#include "src/scene/part_levels.hpp"
#include "src/scene/read_drawing.hpp"

namespace abut {

namespace {

/// Parts by number, each once.
using PartSet = std::set<int>;

bool overlaps_as_plates_do(const Encounter& m) {
    return m.overlap && m.too_deep;
}

/// The round holes of a part.
std::vector<geometry::Arc> eyes_of(const geometry::Part& part, double tolerance) {
    std::vector<geometry::Arc> eyes;
    for (std::size_t k = 1; k < part.loops.size(); ++k) {
        const std::vector<int>& edges = part.loops[k].edges;
        const auto* first = std::get_if<geometry::Arc>(&curve_of(part, edges.front()));
        if (first && std::all_of(edges.begin(), edges.end(), [&](int e) {
                const auto* arc = std::get_if<geometry::Arc>(&curve_of(part, e));
                return arc && (arc->center - first->center).norm() + std::abs(arc->radius - first->radius) <= tolerance;
            }))
            eyes.push_back(*first);
    }
    return eyes;
}

/// Round holes of both parts at one place, of one size, in which nothing is drawn.
std::vector<geometry::Arc> empty_eyes(const Scene& scene, const Encounter& m) {
    const double tolerance = touching_length(part_of(scene, m.first), part_of(scene, m.second));
    std::vector<geometry::Arc> found;
    for (const geometry::Arc& a : eyes_of(part_of(scene, m.first), tolerance))
        for (const geometry::Arc& b : eyes_of(part_of(scene, m.second), tolerance)) {
            geometry::Box2 box;
            for (const double side : {-1.0, 1.0}) box.extend(a.center + side * Vec2(a.radius, a.radius));
            const bool is_same = (a.center - b.center).norm() + std::abs(a.radius - b.radius) <= tolerance;
            if (is_same && std::none_of(scene.parts.begin(), scene.parts.end(), [&](const ScenePart& part) {
                    return bounding_box(part.part).is_within(box, tolerance);
                }))
                found.push_back(a);
        }
    return found;
}

/// Which parts lie over which, and which join them.
class LevelStack {
public:
    explicit LevelStack(const Scene& scene)
        : scene_(scene), encounters_(find_encounters(scene, 1)), beside_(scene.parts.size()) {
        find_pins();
        for (const Encounter& m : encounters_) {
            if (!overlaps_as_plates_do(m)) continue;
            for (const int a : plates_of(m.first))
                for (const int b : plates_of(m.second))
                    if (a != b) {
                        beside_[at(a)].insert(b);
                        beside_[at(b)].insert(a);
                    }
        }
    }

    const std::vector<Encounter>& encounters() const { return encounters_; }

    /// The plates that pins join, or could, directly or through what lies over them, by the first of each group.
    std::vector<PartSet> groups() const {
        PartSet joined;
        for (const auto& [pin, around] : joined_by_) joined.merge(plates_of(pin));
        for (const Encounter& m : encounters_)
            if (overlaps_as_plates_do(m) && !empty_eyes(scene_, m).empty()) joined.insert({m.first, m.second});
        std::set<PartSet> found;
        for (const int plate : joined)
            if (!beside_[at(plate)].empty()) found.insert(connected(plate));
        return {found.begin(), found.end()};
    }

    /// Levels of the plates of a group, from 1.
    std::map<int, int> levels_of(const PartSet& group) const {
        std::map<int, int> level;
        while (level.size() < group.size()) {
            std::optional<int> next;
            std::size_t most = 0;
            for (const int plate : group) {
                const std::size_t taken = levels_beside(plate, level).size();
                if (level.contains(plate) || (next && taken <= most)) continue;
                next = plate;
                most = taken;
            }
            int own = 1;
            for (const PartSet taken = levels_beside(*next, level); taken.contains(own);) ++own;
            level[*next] = own;
        }
        return level;
    }

    /// The pins that join some of these plates.
    PartSet pins_of(const PartSet& group) const {
        PartSet found;
        for (const auto& [pin, joined] : joined_by_) {
            const PartSet plates = plates_of(pin);
            if (std::any_of(plates.begin(), plates.end(), [&](int plate) { return group.contains(plate); })) found.insert(pin);
        }
        return found;
    }

    /// A plate itself; of a pin the plates in whose holes it lies, or in those of the bushes around it.
    PartSet plates_of(int part) const {
        const auto pin = joined_by_.find(part);
        if (pin == joined_by_.end()) return {part};
        PartSet plates;
        for (const int around : pin->second) plates.merge(plates_of(around));  // each lies in a larger outline: this ends
        return plates;
    }

private:
    /// A pin faces the holes of two parts that overlap.
    void find_pins() {
        std::map<int, PartSet> holds;
        std::set<std::pair<int, int>> over;
        for (const Encounter& m : encounters_) {
            if (overlaps_as_plates_do(m))
                over.insert({m.first, m.second});
            else if (!m.candidates.empty() && geometry::lies_in_outline(part_of(scene_, m.first), part_of(scene_, m.second)))
                holds[m.first].insert(m.second);
            else if (!m.candidates.empty() && geometry::lies_in_outline(part_of(scene_, m.second), part_of(scene_, m.first)))
                holds[m.second].insert(m.first);
        }
        for (const auto& [pin, around] : holds)
            if (std::any_of(over.begin(), over.end(), [&held = around](const auto& pair) {
                    return held.contains(pair.first) && held.contains(pair.second);
                }))
                joined_by_[pin] = around;
    }

    PartSet connected(int plate) const {
        PartSet group{plate};
        std::vector<int> open{plate};
        while (!open.empty()) {
            const int next = open.back();
            open.pop_back();
            for (const int other : beside_[at(next)])
                if (group.insert(other).second) open.push_back(other);
        }
        return group;
    }

    PartSet levels_beside(int plate, const std::map<int, int>& level) const {
        PartSet taken;
        for (const int other : beside_[at(plate)])
            if (const auto known = level.find(other); known != level.end()) taken.insert(known->second);
        return taken;
    }

    const Scene& scene_;
    std::vector<Encounter> encounters_;
    std::map<int, PartSet> joined_by_;  // by pin: what it lies in
    std::vector<PartSet> beside_;       // by plate: those that cannot lie on its level
};

std::string names_of(const Scene& scene, const PartSet& parts) {
    std::vector<std::string> names;
    for (const int part : parts) names.push_back(scene_part(scene, part).name);
    return joined(names, ", ");
}

/// A guess for the parts of a scene.
struct GuessedLevels {
    std::vector<Levels> of;  ///< by part
    std::vector<geometry::SketchProblem> told;
};

/// Where two of these plates overlap.
Vec2 place_of_group(const LevelStack& stack, const PartSet& group) {
    for (const Encounter& m : stack.encounters())
        if (overlaps_as_plates_do(m) && group.contains(m.first) && group.contains(m.second)) return m.overlap->at;
    return {0, 0};
}

/// A pin that the drawing leaves out, as the scene would have it.
void tell_empty_eyes(const Scene& scene, const Encounter& m, GuessedLevels& guessed) {
    Levels on = guessed.of[at(m.first)];
    on.insert(on.end(), guessed.of[at(m.second)].begin(), guessed.of[at(m.second)].end());
    std::sort(on.begin(), on.end());
    const std::string pair = scene_part(scene, m.first).name + " and " + scene_part(scene, m.second).name;
    constexpr int digits = 9;
    for (const geometry::Arc& eye : empty_eyes(scene, m))
        guessed.told.push_back({"no pin is drawn in the common hole of " + pair, eye.center, pair, 0,
                                "where one joins them, add it to the scene: \"parts\": [{\"name\": \"pin\", \"material\": "
                                "\"steel\", \"level\": [" +
                                    levels_text(on) + "], \"geometry\": {\"circle\": {\"center\": [" +
                                    number_text(eye.center.x(), digits) + ", " + number_text(eye.center.y(), digits) +
                                    "], \"radius\": " + number_text(eye.radius, digits) + "}}}]"});
}

/// Do any two parts with holes overlap? Others are no plates that a pin joins; asked first, since it costs far less than all
/// encounters.
bool have_overlapping_plates(const Scene& scene) {
    const SearchDistances distances(scene);
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        for (std::size_t k = i + 1; k < scene.parts.size(); ++k) {
            const geometry::Part &a = scene.parts[i].part, &b = scene.parts[k].part;
            if (a.loops.size() < 2 || b.loops.size() < 2) continue;
            const double touching = distances.touching(static_cast<int>(i), static_cast<int>(k));
            if (overlap(a, b, touching).depth > touching) return true;
        }
    return false;
}

GuessedLevels guess_levels(const Scene& scene, const std::string& what_of_it, const std::string& hint) {
    GuessedLevels guessed{std::vector<Levels>(scene.parts.size()), {}};
    if (!have_overlapping_plates(scene)) return guessed;
    const LevelStack stack(scene);
    for (const PartSet& group : stack.groups()) {
        const std::map<int, int> level = stack.levels_of(group);
        const PartSet pins = stack.pins_of(group);
        for (const auto& [plate, own] : level) guessed.of[at(plate)] = {own};
        for (const int pin : pins) {
            PartSet on(guessed.of[at(pin)].begin(), guessed.of[at(pin)].end());
            for (const int plate : stack.plates_of(pin))
                if (const auto known = level.find(plate); known != level.end()) on.insert(known->second);
            guessed.of[at(pin)].assign(on.begin(), on.end());
        }
        std::string text;
        PartSet all = group;
        all.insert(pins.begin(), pins.end());
        for (const int part : all)
            text += (text.empty() ? "" : "; ") + scene_part(scene, part).name + " " + levels_text(guessed.of[at(part)]);
        guessed.told.push_back(
            {names_of(scene, group) + " overlap in the plan, and " +
                 (pins.empty() ? "have round holes in common"
                               : "parts that fit holes of two of them join them (" + names_of(scene, pins) + ")") +
                 ": " + what_of_it + ", levels " + text,
             place_of_group(stack, group), names_of(scene, group), 0, hint});
        for (const Encounter& m : stack.encounters())
            if (group.contains(m.first) && group.contains(m.second) && overlaps_as_plates_do(m))
                tell_empty_eyes(scene, m, guessed);
    }
    for (const Encounter& m : stack.encounters()) {
        if (overlaps_as_plates_do(m) || (m.candidates.empty() && !m.unpaired) ||
            have_common_level(guessed.of[at(m.first)], guessed.of[at(m.second)]))
            continue;
        const std::string pair = scene_part(scene, m.first).name + " and " + scene_part(scene, m.second).name;
        guessed.told.push_back(
            {pair + " come close to each other, but have none of these levels in common: no contact between them",
             m.closest ? m.closest->x1 : Vec2(0, 0), pair, 0, "give them a common \"level\" where they meet"});
    }
    return guessed;
}

void tell(Scene& scene, const GuessedLevels& guessed) {
    for (const geometry::SketchProblem& warning : guessed.told) {
        scene.imports.back().warnings.push_back(warning);
        scene.warnings.push_back(warning_text(scene.file, warning));
    }
}

}  // namespace

void take_guessed_levels(Scene& scene) {
    const GuessedLevels guessed =
        guess_levels(scene, "taken as lying above each other",
                     "check \"level\" of these parts in the scene; parts without it lie on all levels");
    for (std::size_t i = 0; i < scene.parts.size(); ++i) scene.parts[i].level = guessed.of[i];
    tell(scene, guessed);
}

void tell_guessed_levels(Scene& scene) {
    tell(scene, guess_levels(scene, "they look as if they lay above each other",
                             "a scene says so by \"level\" of its parts: abut init writes one"));
}

}  // namespace abut
