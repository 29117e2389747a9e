// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_material.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/brep/closest_points.hpp"
#include "geometry/sketch/sketch_hatches.hpp"
#include "geometry/sketch/sketch_names.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// As near as this fraction of the smaller diagonal, parts are looked at as a pair.
constexpr double near_fraction = 0.02;

/// "r3"
bool is_region_name(const std::string& text) {
    return text.size() > 1 && text[0] == 'r' && text.find_first_not_of("0123456789", 1) == std::string::npos;
}

struct Decision {
    std::vector<Region>& regions;
    const Outlines& outlines;
    const MaterialHints& hints;
    std::vector<SketchProblem>& warnings;
    std::vector<bool> is_strip{}, holds_strip{};                   ///< by region: a clearance; directly around one
    std::vector<int> n_faces_at{};                                 ///< by entity: faces of divided outlines
    std::array<std::vector<std::set<std::string>>, 2> drawn_on{};  ///< by region: layers, blocks
    std::set<std::string> outer_layers{};                          ///< of outlines that lie in no other
    bool is_all_twice = false;

    const SketchPiece& piece(int entity) const { return outlines.entities[at(entity)]; }
    std::string name(int region) const { return "r" + std::to_string(hints.first_number + region); }

    bool is_twice(const Region& region) const {
        return std::all_of(region.entity.begin(), region.entity.end(), [&](int e) { return piece(e).times_drawn % 2 == 0; });
    }

    bool is_inside_material(const Region& region) const { return region.around >= 0 && regions[at(region.around)].is_filled; }

    /// The layers, or the blocks, that the outlines are drawn on.
    void find_what_is_drawn_on() {
        for (const bool by_block : {false, true})
            for (const Region& region : regions) {
                std::set<std::string>& all = drawn_on[by_block ? 1 : 0].emplace_back();
                for (const int e : region.entity) {
                    all.insert(by_block ? piece(e).block : piece(e).layer);
                    if (!by_block) all.insert(piece(e).also_on.begin(), piece(e).also_on.end());
                }
            }
    }

    std::string mostly_on(const Region& region, bool by_block) const {
        std::map<std::string, int> n;
        for (const int e : region.entity) ++n[by_block ? piece(e).block : piece(e).layer];
        return std::max_element(n.begin(), n.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;
    }

    /// Is an outline inside another one drawn on nothing that the other is drawn on?
    bool is_foreign(int i, bool by_block) const {
        const Region& region = regions[at(i)];
        if (hints.is_one_part || region.around < 0) return false;
        const std::set<std::string>&on = drawn_on[by_block ? 1 : 0][at(i)],
              &around = drawn_on[by_block ? 1 : 0][at(region.around)];
        return std::none_of(on.begin(), on.end(), [&](const std::string& layer) { return around.contains(layer); });
    }

    /// Do layers separate the parts: are there outlines of several, is none of these on the layer of this one, and does that
    /// not hold its hole alone?
    bool is_on_layer_of_its_own(int i) const {
        const std::set<std::string>& on = drawn_on[0][at(i)];
        if (!hints.layers_tell || on.size() != 1 || outer_layers.size() < 2 || outer_layers.contains(*on.begin()) ||
            hints.hole_layers.contains(*on.begin()))
            return false;
        for (std::size_t k = 0; k < regions.size(); ++k)
            if (regions[k].around == i && is_foreign(static_cast<int>(k), false)) return false;
        return true;
    }

    // ---- areas that share edges ----

    /// Are there areas on all sides?
    bool is_enclosed(const Region& region) const {
        return std::all_of(region.entity.begin(), region.entity.end(), [&](int e) { return n_faces_at[at(e)] == 2; }) ||
               (is_inside_material(region) && !region.entity.empty());
    }

    /// Does some line of its boundary go on beyond it?
    bool has_lines_that_go_on(const Region& region) const {
        std::map<int, double> own;
        for (const int e : region.entity)
            for (const int source : piece(e).of) own[source] += length(piece(e).curve);
        constexpr double same = 1e-6;
        return std::any_of(region.entity.begin(), region.entity.end(), [&](int e) {
            const SketchPiece& p = piece(e);
            return p.of.size() == 1 && own[p.of.front()] < (1 - same) * p.whole_length;
        });
    }

    /// A clearance is a narrow strip: wide areas that nobody drew may as well be parts whose lines were shortened to others'.
    bool is_narrow(const Region& region) const {
        constexpr double most = 0.1;  // of 4 area / perimeter^2, width by length of a strip
        const double around = perimeter(region.outline);
        return 4 * region.area < most * around * around;
    }

    bool is_cavity(const Region& region) const {
        return is_narrow(region) && is_enclosed(region) && has_lines_that_go_on(region) &&
               std::none_of(region.entity.begin(), region.entity.end(), [&](int e) { return piece(e).times_drawn > 1; });
    }

    /// Does a line that was drawn once have it on one side and another area on the other?
    bool has_shared_lines(const Region& region) const {
        return std::any_of(region.entity.begin(), region.entity.end(),
                           [&](int e) { return n_faces_at[at(e)] == 2 && piece(e).times_drawn == 1; });
    }

    bool fill_face(Region& region) {
        const bool is_even_odd = outlines.divided[at(region.divided)].is_even_odd;
        if (is_even_odd) return region.is_face_filled != is_inside_material(region);
        if (!is_cavity(region)) return true;
        region.is_doubtful = true;
        return false;
    }

    // ---- clearances around pins ----

    /// By region: is there one outline in it that comes as near as parts of a pair?
    std::vector<bool> are_thin() const {
        std::vector<int> n_inside(regions.size(), 0), inside(regions.size(), -1);
        for (std::size_t i = 0; i < regions.size(); ++i)
            if (regions[i].around >= 0) {
                ++n_inside[at(regions[i].around)];
                inside[at(regions[i].around)] = static_cast<int>(i);
            }
        std::vector<bool> is_thin(regions.size(), false);
        for (std::size_t i = 0; i < regions.size(); ++i) {
            if (n_inside[i] != 1 || regions[i].divided >= 0 || regions[at(inside[i])].divided >= 0) continue;
            const Region &outer = regions[i], &inner = regions[at(inside[i])];
            const double width = 2 * (outer.area - inner.area) / (perimeter(outer.outline) + perimeter(inner.outline));
            is_thin[i] = width < near_fraction * inner.box.diagonal();
        }
        return is_thin;
    }

    /// The thin strip between two outlines, one in the other: air, for what is in it would hang in the air otherwise, and
    /// inside a hole nothing as thin is made; unless what the hole is in is as thin itself.
    void find_strips() {
        const std::vector<bool> is_thin = are_thin();
        is_strip.assign(regions.size(), false);
        holds_strip.assign(regions.size(), false);
        for (std::size_t i = 0; i < regions.size(); ++i) {
            const int hole = regions[i].around;
            if (!is_thin[i] || hole < 0 || (regions[at(hole)].around >= 0 && is_thin[at(regions[at(hole)].around)])) continue;
            is_strip[i] = holds_strip[at(hole)] = true;
        }
    }

    // ---- all ----

    /// Does another group have material at this point of the region, inside outlines that lie in it?
    bool is_anothers(const Region& region, const Vec2& inside) const {
        const auto is_around = [&](const Region& other) {
            return other.box.is_within(region.box, near_fraction * region.box.diagonal()) &&
                   contains(finder_of(other).pieces, inside);
        };
        for (std::size_t g = 0; g < hints.of_groups.size(); ++g)
            if (g != hints.group && std::count_if(hints.of_groups[g].begin(), hints.of_groups[g].end(), is_around) % 2 != 0)
                return true;
        return false;
    }

    bool fill(int i, const Vec2& inside) {
        Region& region = regions[at(i)];
        const auto choice = hints.choices.find(name(i));
        region.is_chosen = choice != hints.choices.end();
        if (region.is_chosen) {
            const std::string& what = choice->second;
            if (is_region_name(what))
                region.joins = what;
            else if (what != "void" && what != "part")
                region.name = what;
            return what != "void";
        }
        const bool is_inside = is_inside_material(region);
        if (is_inside && is_anothers(region, inside)) region.hatches.clear();
        if (!region.hatches.empty() || region.is_overlaid) return true;
        if (region.divided >= 0) return fill_face(region);
        if (is_twice(region) && !is_all_twice && !hints.is_one_part) return true;
        if (is_strip[at(i)]) return false;
        if (is_inside && holds_strip[at(i)]) region.is_doubtful = true;  // a bush whose fit is drawn once
        return !is_inside || holds_strip[at(i)] || (is_foreign(i, false) && is_on_layer_of_its_own(i));
    }

    void count_faces() {
        n_faces_at.assign(outlines.entities.size(), 0);
        for (const Region& region : regions)
            if (region.divided >= 0)
                for (const int e : region.entity) ++n_faces_at[at(e)];
    }

    void find_hatches(const std::vector<Vec2>& points) {
        if (hints.hatches.empty()) return;
        const HatchedAreas areas(hints.hatches);
        for (std::size_t i = 0; i < regions.size(); ++i) regions[i].hatches = areas.at_point(points[i]);
    }

    void decide(const std::vector<Vec2>& points) {
        count_faces();
        find_hatches(points);
        find_strips();
        find_what_is_drawn_on();
        for (std::size_t i = 0; i < regions.size(); ++i)
            if (regions[i].around < 0) outer_layers.insert(drawn_on[0][i].begin(), drawn_on[0][i].end());
        is_all_twice = std::all_of(regions.begin(), regions.end(), [&](const Region& r) { return is_twice(r); });
        std::vector<int> outermost_first(regions.size());
        std::iota(outermost_first.begin(), outermost_first.end(), 0);
        std::stable_sort(outermost_first.begin(), outermost_first.end(),
                         [&](int a, int b) { return regions[at(a)].area > regions[at(b)].area; });
        for (const int i : outermost_first) regions[at(i)].is_filled = fill(i, points[at(i)]);
    }

    // ---- what was taken ----

    void tell(int i, const std::string& what, const Vec2& where, const std::string& hint) {
        const SketchPiece& first = piece(regions[at(i)].first_entity);
        warnings.push_back({what, where, first.name, first.line, hint});
    }

    std::string listed(const std::vector<int>& numbers) const {
        constexpr std::size_t most = 12;
        std::string text;
        for (std::size_t k = 0; k < std::min(numbers.size(), most); ++k) text += (k == 0 ? "" : ", ") + name(numbers[k]);
        return numbers.size() > most ? text + ", ..." : text;
    }

    bool is_said(int i) const { return !regions[at(i)].hatches.empty() || regions[at(i)].is_chosen; }

    /// One warning for each divided outline in which something was not certain.
    void tell_divided(const std::vector<Vec2>& points) {
        for (std::size_t d = 0; d < outlines.divided.size(); ++d) {
            std::vector<int> filled, open;
            bool any_hatched = false;
            for (std::size_t i = 0; i < regions.size(); ++i) {
                if (regions[i].divided != static_cast<int>(d)) continue;
                any_hatched = any_hatched || !regions[i].hatches.empty();
                if (is_said(static_cast<int>(i))) continue;
                if (!regions[i].is_filled)
                    open.push_back(static_cast<int>(i));
                else if (has_shared_lines(regions[i]))
                    filled.push_back(static_cast<int>(i));
            }
            for (const int i : open) regions[at(i)].is_doubtful = true;
            for (const int i : filled) regions[at(i)].is_doubtful = true;
            const std::string& layer = piece(outlines.divided[d].contour.front().entity).layer;
            const std::string hint = "where that is wrong, say so in the scene: \"regions\": {\"" +
                                     name(open.empty() ? (filled.empty() ? 0 : filled.front()) : open.front()) +
                                     (open.empty() ? "\": \"void\"}" : "\": \"part\"}") +
                                     block_hint(piece(outlines.divided[d].contour.front().entity));
            if (!open.empty())
                tell(open.front(),
                     "areas on layer " + layer + " that other outlines enclose are taken as empty: " + listed(open),
                     points[at(open.front())], hint);
            if (!filled.empty() && any_hatched)
                tell(filled.front(),
                     "areas on layer " + layer +
                         " without a hatch, beside others that have one, are taken as parts: " + listed(filled),
                     points[at(filled.front())], hint);
            else if (filled.size() > 1)
                tell(filled.front(),
                     "outlines on layer " + layer +
                         " share lines that are drawn once; areas on both sides are taken as parts: " + listed(filled),
                     points[at(filled.front())], hint);
        }
    }

    bool is_near_another(int i) const {
        const Region& own = regions[at(i)];
        for (std::size_t k = 0; k < regions.size(); ++k) {
            const Region& other = regions[k];
            const bool is_hole_around = static_cast<int>(k) == own.around;
            if (static_cast<int>(k) == i || (!is_hole_around && !other.is_filled)) continue;
            const double reach = near_fraction * std::min(own.box.diagonal(), other.box.diagonal());
            if (own.box.overlaps(other.box, reach) && closest_points(own.outline, other.outline, reach)) return true;
        }
        return false;
    }

    void tell_floating(const std::vector<Vec2>& points) {
        std::vector<int> floating;
        for (std::size_t i = 0; i < regions.size(); ++i) {
            const Region& own = regions[i];
            if (!own.is_filled || own.around < 0 || regions[at(own.around)].is_filled || own.divided >= 0) continue;
            if (!is_said(static_cast<int>(i)) && !is_near_another(static_cast<int>(i))) floating.push_back(static_cast<int>(i));
        }
        if (floating.empty()) return;
        for (const int i : floating) regions[at(i)].is_doubtful = true;
        const int around = regions[at(floating.front())].around;
        tell(floating.front(),
             "outlines inside a hole that touch nothing are taken as parts with air around them, not as bushes or edges: " +
                 listed(floating),
             points[at(floating.front())],
             "draw a bush by both of its parts or hatch it, or say what the area around is: \"regions\": {\"" + name(around) +
                 "\": \"part\"}");
    }

    /// Outlines in material that are drawn on other layers or in other blocks than what they lie in: holes, or parts.
    void tell_foreign(const std::vector<Vec2>& points) {
        std::vector<char> holds_part(regions.size(), 0);
        for (const Region& region : regions)
            if (region.is_filled && region.around >= 0) holds_part[at(region.around)] = 1;
        std::map<std::tuple<bool, std::string, std::string>, std::vector<int>>
            found;  // by what they and their parts are drawn on
        for (std::size_t i = 0; i < regions.size(); ++i) {
            const Region& own = regions[i];
            if (own.divided >= 0 || !is_inside_material(own) || is_said(static_cast<int>(i))) continue;
            const int number = static_cast<int>(i);
            if (own.is_filled ? !is_foreign(number, false) : holds_part[i] != 0) continue;
            for (const bool by_block : {false, true}) {
                if (!is_foreign(number, by_block)) continue;
                const std::string of = by_block ? "block " : "layer ", on = mostly_on(own, by_block),
                                  around = mostly_on(regions[at(own.around)], by_block);
                if (on.empty() || (!own.is_filled && hints.hole_layers.contains(on))) continue;
                found[{own.is_filled, of + on, around.empty() ? "no block" : of + around}].push_back(static_cast<int>(i));
                break;
            }
        }
        for (const auto& [on, outlines_on] : found) {
            const auto& [are_parts, own, around] = on;
            for (const int i : outlines_on) regions[at(i)].is_doubtful = true;
            const bool by_layer = own.starts_with("layer");
            const std::string is = by_layer ? "on " : "of ", first = name(outlines_on.front());
            tell(outlines_on.front(),
                 "outlines " + is + own + " lie in the material of what is " + is + around + ", and are taken as " +
                     (are_parts ? "parts that fit there: " : "its holes: ") + listed(outlines_on),
                 points[at(outlines_on.front())],
                 are_parts ? "where they are holes, say so in the scene: \"regions\": {\"" + first + "\": \"void\"}"
                           : "where they are parts, say so in the scene: \"regions\": {\"" + first + "\": \"part\"}" +
                                 (by_layer ? ", or --parts-by layer (\"parts_by\": \"layer\")" : ""));
        }
    }

    void tell_bushes(const std::vector<Vec2>& points) {
        for (std::size_t i = 0; i < regions.size(); ++i)
            if (holds_strip[i] && regions[i].divided < 0 && regions[i].is_doubtful && regions[i].is_filled)
                tell(static_cast<int>(i),
                     "an outline in a part with another and its clearance inside is taken as a bush that fits the part "
                     "around: " +
                         name(static_cast<int>(i)),
                     points[i], "say \"regions\": {\"" + name(static_cast<int>(i)) + "\": \"void\"} where it is air");
    }
};

}  // namespace

std::vector<SketchRegion> decide_material(std::vector<Region>& regions, const Outlines& outlines, const MaterialHints& hints,
                                          std::vector<SketchProblem>& warnings) {
    const std::vector<Vec2> points = inner_points(regions);
    Decision decision{regions, outlines, hints, warnings};
    decision.decide(points);
    decision.tell_divided(points);
    decision.tell_floating(points);
    if (!hints.is_one_part) decision.tell_foreign(points);
    decision.tell_bushes(points);
    std::vector<SketchRegion> named;
    for (std::size_t i = 0; i < regions.size(); ++i)
        named.push_back({decision.name(static_cast<int>(i)), points[i], {}, regions[i].is_doubtful});
    return named;
}

}  // namespace abut::geometry
