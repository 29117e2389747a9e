// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/stray_selections.hpp"

#include <algorithm>
#include <set>

#include "geometry/brep/part.hpp"
#include "src/base/index.hpp"
#include "src/scene/selection.hpp"

namespace abut {

namespace {

bool is_whole(const EdgePortion& p) {
    return p.t0 == 0 && p.t1 == 1;
}

/// Do two portions of one part meet at an end?
bool adjoin(const geometry::Part& part, const EdgePortion& a, const EdgePortion& b) {
    const geometry::Curve &on_a = part.edges[at(a.edge)].curve, &on_b = part.edges[at(b.edge)].curve;
    const double merged = geometry::merge_length(part);
    for (const double s : {a.t0, a.t1})
        for (const double t : {b.t0, b.t1})
            if ((geometry::point(on_a, s) - geometry::point(on_b, t)).norm() <= merged) return true;
    return false;
}

bool is_of_hole(const Scene& scene, const EdgePortion& p) {
    const geometry::Part& part = scene.parts[at(p.part)].part;
    const geometry::Loop* loop = geometry::loop_of(part, p.edge);
    if (!loop) return false;
    geometry::Part alone;  // a hole's area counts negative
    for (const int edge : loop->edges) alone.edges.push_back(part.edges[at(edge)]);
    return geometry::area(alone) < 0;
}

/// Names of the edges that are taken which no chain of portions joins to a whole edge, nor, where any is on an outline, to a
/// whole edge of an outline; none where none is whole.
std::set<std::string> strays(const Scene& scene, const Selector& selector) {
    std::vector<EdgePortion> joined, rest;
    for (const EdgePortion& p : select(scene, {selector})) (is_whole(p) ? joined : rest).push_back(p);
    if (joined.empty()) return {};
    const auto holes =
        std::stable_partition(joined.begin(), joined.end(), [&](const EdgePortion& p) { return !is_of_hole(scene, p); });
    if (holes != joined.begin()) {
        rest.insert(rest.end(), holes, joined.end());
        joined.erase(holes, joined.end());
    }
    for (std::size_t k = 0; k < joined.size(); ++k)
        for (std::size_t i = rest.size(); i-- > 0;)
            if (rest[i].part == joined[k].part && adjoin(scene.parts[at(rest[i].part)].part, rest[i], joined[k])) {
                joined.push_back(rest[i]);
                rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
            }
    std::set<std::string> names;
    for (const EdgePortion& p : rest) {
        const ScenePart& part = scene.parts[at(p.part)];
        names.insert(part.name + "/" + part.part.edges[at(p.edge)].name);
    }
    return names;
}

void append_others_as_near(const Scene& scene, const Selector& selector, std::vector<std::string>& texts) {
    for (const ScenePart& part : scene.parts) {
        if (part.name != selector.part) continue;
        const std::vector<int> edges = nearest_edges(part.part, *selector.near).edges;
        const auto name = [&](int edge) { return part.name + "/" + part.part.edges[at(edge)].name; };
        std::string others;
        for (std::size_t k = 1; k < edges.size(); ++k) others += (k > 1 ? ", " : "") + name(edges[k]);
        if (!others.empty())
            texts.push_back(selector.where + ": " + name(edges[0]) + " is selected, and " + others +
                            (edges.size() > 2 ? " are" : " is") +
                            " as near to this place; give one beside the edge that is meant, or name it");
    }
}

void append(const Scene& scene, const Selection& on, std::vector<std::string>& texts) {
    for (const Selector& selector : on) {
        if (selector.near) append_others_as_near(scene, selector, texts);
        if (!selector.facing) continue;
        std::string pieces;
        for (const std::string& name : strays(scene, selector)) pieces += (pieces.empty() ? "" : ", ") + name;
        if (!pieces.empty())
            texts.push_back(selector.where + ": " + pieces +
                            " faces this way, too, or a piece of it, and is selected beside other edges that do; if it is "
                            "not meant, name those, or select them by near or box");
    }
}

}  // namespace

std::vector<std::string> stray_selections(const Scene& scene) {
    std::vector<std::string> texts;
    for (const Support& support : scene.supports) append(scene, support.on, texts);
    for (const Load& load : scene.loads) append(scene, load.on, texts);
    return texts;
}

}  // namespace abut
