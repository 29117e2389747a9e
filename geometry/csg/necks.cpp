// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/necks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/csg/junction.hpp"

namespace abut::geometry {

namespace {

using RunLoop = std::vector<Run>;

bool same_way(const Run& a, const Run& b) {
    return a.source == b.source && a.along == b.along;
}

/// Is the curve's point next to p no farther than the distance?
bool passes(const Curve& curve, const Run& run, const Vec2& p, double distance) {
    return std::abs((p - point(curve, closest_parameter(curve, p))).norm()) <= distance ||
           (p - run.from.at).norm() <= distance || (p - run.to.at).norm() <= distance;
}

/// Does run a, beyond its end, go on into run b over a gap that both curves follow? The gap of a lens thinner than `rounding`
/// on curves of this size is no longer than the root of both.
bool goes_on_over_neck(const Run& a, const Run& over, const Run& b, const RunContext& context) {
    const Vec2 gap = b.from.at - a.to.at;
    if (gap.norm() <= context.lengths.merge) return true;
    const Curve &curve = context.curve(a), &other = context.curve(over);
    const double size = bounding_box(curve).diagonal() + bounding_box(other).diagonal();
    if (gap.norm() > 4 * std::sqrt(context.lengths.rounding * size)) return false;
    const double middle = closest_parameter(curve, 0.5 * (a.to.at + b.from.at));
    const Vec2 ahead = (a.along ? 1 : -1) * unit_tangent(curve, middle);
    return gap.dot(ahead) > 0 && passes(other, over, point(curve, middle), context.lengths.rounding);
}

struct Neck {
    std::size_t end, begin;  ///< the loop changes over behind run `end` and comes back before run `begin`
};

bool is_neck(const RunLoop& loop, std::size_t i, std::size_t j, const RunContext& context) {
    const std::size_t n = loop.size(), over = (i + 1) % n, back = (j + n - 1) % n;
    return over != j && same_way(loop[over], loop[back]) && goes_on_over_neck(loop[i], loop[over], loop[j], context) &&
           goes_on_over_neck(loop[back], loop[j], loop[over], context);
}

std::optional<Neck> find_neck(const RunLoop& loop, const RunContext& context) {
    std::map<std::pair<int, bool>, std::vector<std::size_t>> runs;  // of each source, each way
    for (std::size_t i = 0; i < loop.size(); ++i) runs[{loop[i].source, loop[i].along}].push_back(i);
    for (const auto& [source, list] : runs)
        for (const std::size_t i : list)
            for (const std::size_t j : list)
                if (is_neck(loop, i, j, context)) return Neck{i, j};
    return {};
}

/// Runs first .. last around the loop, of which the last goes on into the first.
RunLoop closed(const RunLoop& loop, std::size_t first, std::size_t last, const RunContext& context) {
    RunLoop part;
    for (std::size_t i = first; i != last; i = (i + 1) % loop.size()) part.push_back(loop[i]);
    if (part.empty()) {
        part.push_back(loop[first]);
        part.front().whole = is_full(context.curve(part.front()));
        return part;
    }
    const Run& begin = loop[last];
    if (!goes_on(begin, part.front(), context.curve(begin))) {
        part.push_back(begin);
        return part;
    }
    part.front().seams += begin.seams + static_cast<int>(std::lround(begin.to.t - part.front().from.t));
    part.front().from = begin.from;
    return part;
}

}  // namespace

std::vector<std::vector<Run>> cut_necks(std::vector<Run> loop, const RunContext& context) {
    std::vector<RunLoop> cut;
    while (const auto neck = find_neck(loop, context)) {
        const std::size_t n = loop.size();
        cut.push_back(closed(loop, (neck->end + 1) % n, (neck->begin + n - 1) % n, context));
        loop = closed(loop, neck->begin, neck->end, context);
    }
    cut.push_back(std::move(loop));
    return cut;
}

}  // namespace abut::geometry
