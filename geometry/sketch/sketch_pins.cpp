// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_pins.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/outline.hpp"
#include "geometry/csg/overlap.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// Of a pin's size: what is nearer touches, and of its area: rounding.
constexpr double pin_rounding = 1e-6;

/// Which parts have some place in common, neither inside the other. A hole within both changes nothing.
class LaidAcross {
public:
    explicit LaidAcross(const std::vector<Part>& parts) : parts_(parts) {}

    bool operator()(std::size_t i, std::size_t j) {
        const auto [found, is_new] = known_.try_emplace(std::minmax(i, j));
        if (is_new) found->second = are_across(parts_[i], parts_[j]);
        return found->second;
    }
    bool any(std::size_t plate, const std::vector<std::size_t>& others) {
        return std::any_of(others.begin(), others.end(),
                           [&](std::size_t other) { return other != plate && (*this)(plate, other); });
    }

private:
    static bool are_across(const Part& a, const Part& b) {
        const double tolerance = pin_rounding * std::min(bounding_box(a).diagonal(), bounding_box(b).diagonal());
        return !lies_in_outline(a, b) && !lies_in_outline(b, a) && overlap(a, b, tolerance).area > 0;
    }

    const std::vector<Part>& parts_;
    std::map<std::pair<std::size_t, std::size_t>, bool> known_;
};

bool is_drawn_without_it(const Part& pin, const Part& plate) {
    const double own = area(outer_outline(pin));
    return overlap(outer_outline(pin), plate, pin_rounding * bounding_box(pin).diagonal()).area > (1 - pin_rounding) * own;
}

void cut_out(const Part& pin, Part& plate) {
    Loop hole;
    const std::vector<int>& outer = pin.loops.front().edges;
    for (auto e = outer.rbegin(); e != outer.rend(); ++e) {
        Edge edge = pin.edges[at(*e)];
        edge.curve = reversed(edge.curve);
        edge.along_source = !edge.along_source;
        hole.edges.push_back(static_cast<int>(plate.edges.size()));
        plate.edges.push_back(std::move(edge));
    }
    plate.loops.push_back(std::move(hole));
}

using PartNumbers = std::vector<std::size_t>;

/// Of the parts around a pin those that lack its hole; none where some that have it are joined: the others lie over them.
PartNumbers plates_without_hole(const std::vector<Part>& parts, const PartNumbers& around, std::size_t pin,
                                LaidAcross& are_laid_across) {
    PartNumbers with, without;
    for (const std::size_t plate : around)
        if (are_laid_across.any(plate, around))
            (is_drawn_without_it(parts[pin], parts[plate]) ? without : with).push_back(plate);
    const bool is_joined =
        std::any_of(with.begin(), with.end(), [&](std::size_t plate) { return are_laid_across.any(plate, with); });
    return is_joined ? PartNumbers{} : without;
}

}  // namespace

void cut_pins(std::vector<Part>& parts, const std::vector<std::string>& group, std::vector<SketchProblem>& warnings) {
    ENSURE(parts.size() == group.size(), "every part is of some group");
    std::vector<Box2> boxes;
    for (const Part& part : parts) boxes.push_back(bounding_box(part));
    const EdgeTree tree(boxes);
    LaidAcross are_laid_across(parts);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        PartNumbers around;
        for (const int near : tree.near(boxes[p], 0))
            if (group[at(near)] != group[p] && boxes[p].is_within(boxes[at(near)], 0) &&
                lies_in_outline(parts[p], parts[at(near)]))
                around.push_back(at(near));
        std::string cut;
        for (const std::size_t plate : plates_without_hole(parts, around, p, are_laid_across)) {
            cut_out(parts[p], parts[plate]);
            cut += (cut.empty() ? "" : " and ") + parts[plate].name;
        }
        if (cut.empty()) continue;
        const Edge& first = parts[p].edges.front();
        warnings.push_back({parts[p].name +
                                " lies in outlines that cross, as a pin through plates above each other: taken as one, with a "
                                "hole of its size in " +
                                cut,
                            point(first.curve, 0), first.source, 0,
                            "draw the hole on the layer of its part where that is wrong, or ignore the layer of the pin"});
    }
}

}  // namespace abut::geometry
