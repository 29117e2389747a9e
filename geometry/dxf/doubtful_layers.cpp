// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/doubtful_layers.hpp"

#include <algorithm>
#include <map>

#include "geometry/dxf/drafting_layers.hpp"

namespace abut::geometry::dxf {

namespace {

/// Ends of the lines on a layer, looked through one by one: layers of so many lines are no axes.
constexpr std::size_t most_ends = 2000;

struct LayerEnds {
    std::vector<Vec2> ends;
    bool is_loose = false;

    void add(const Curve& curve) {
        constexpr double same = 1e-6;  // of the line's length
        const Vec2 from = point(curve, 0), to = point(curve, 1);
        const double near = same * length(curve);
        const auto is_known = [&](const Vec2& p) {
            return std::any_of(ends.begin(), ends.end(), [&](const Vec2& q) { return (p - q).norm() <= near; });
        };
        if ((to - from).norm() <= near || ends.size() > most_ends || is_known(from) || is_known(to)) is_loose = false;
        ends.push_back(from);
        ends.push_back(to);
    }
};

}  // namespace

std::set<std::string> layers_of_loose_lines(const std::vector<SketchEntity>& entities) {
    std::map<std::string, LayerEnds> layers;
    for (const SketchEntity& entity : entities) {
        const auto [found, is_new] = layers.try_emplace(entity.layer);
        if (is_new) {
            const auto kind = drafting_layer(entity.layer);
            found->second.is_loose = kind && !kind->is_sure && kind->kind != "holes";
        }
        if (found->second.is_loose) found->second.add(entity.curve);
    }
    std::set<std::string> loose;
    for (const auto& [layer, ends] : layers)
        if (ends.is_loose) loose.insert(layer);
    return loose;
}

}  // namespace abut::geometry::dxf
