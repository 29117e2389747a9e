// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/proximity/facing_nearest.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/curves/tangent_ball.hpp"

namespace abut::geometry {

namespace {

/// A part of a stretch, by arc length on edge 1.
struct Span {
    double begin, end;
};

/// Position on edge 1 of the partner of the point at s2 of edge 2; clamped to the stretch.
double image_on_first(const FacingModel& model, const FacingStretch& stretch, double s2) {
    const Curve &curve1 = curve_of(model.part1, stretch.edge1), &curve2 = curve_of(model.part2, stretch.edge2);
    const double t2 = s2 / length(curve2);
    const auto ball = tangent_ball(curve1, point(curve2, t2), outward_normal(curve2, t2));
    const double s1 = ball ? ball->t * length(curve1) : stretch.begin.s1;
    return std::clamp(s1, stretch.begin.s1, stretch.end.s1);
}

double size_of_gap_at(const FacingModel& model, const FacingStretch& stretch, double s1) {
    const auto pair = pair_on_edges(model, stretch.edge1, stretch.edge2, s1);
    return pair ? std::abs(pair->gap) : model.distance;
}

/// Appends the spans inside [low, high] where lead(s), by how much the other partner is nearer, exceeds `same`. They end where
/// lead changes its sign, so that the stretches that share a point of change end at the same place.
template <class Function>
void add_spans(Function lead, double low, double high, double same, std::vector<Span>& spans) {
    constexpr int samples = 8;  // both gaps are monotone: they cross few times
    std::vector<double> cuts{low};
    for (int j = 0; j < samples; ++j) {
        double a = low + (high - low) * j / samples, b = low + (high - low) * (j + 1) / samples;
        const bool behind = lead(a) > same;
        if (behind == (lead(b) > same)) continue;
        const double level = lead(behind ? b : a) > 0 ? same : 0;
        for (double m = 0.5 * (a + b); a < m && m < b; m = 0.5 * (a + b)) ((lead(m) > level) == behind ? a : b) = m;
        cuts.push_back(0.5 * (a + b));
    }
    cuts.push_back(high);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        if (lead(0.5 * (cuts[i] + cuts[i + 1])) > same) spans.push_back({cuts[i], cuts[i + 1]});
}

/// Spans of `own`, by s1, where the point of part 1 has a nearer partner on `other` (same edge 1).
void beaten_on_first(const FacingModel& model, const FacingStretch& own, const FacingStretch& other, std::vector<Span>& spans) {
    const double low = std::max(own.begin.s1, other.begin.s1), high = std::min(own.end.s1, other.end.s1);
    if (high - low <= model.same) return;
    const auto lead = [&](double s1) { return size_of_gap_at(model, own, s1) - size_of_gap_at(model, other, s1); };
    add_spans(lead, low, high, model.same, spans);
}

/// The same for the points of part 2 (same edge 2).
void beaten_on_second(const FacingModel& model, const FacingStretch& own, const FacingStretch& other,
                      std::vector<Span>& spans) {
    const double low = std::max(own.end.s2, other.end.s2), high = std::min(own.begin.s2, other.begin.s2);
    if (high - low <= model.same) return;
    const auto gap_at = [&](const FacingStretch& stretch, double s2) {
        return size_of_gap_at(model, stretch, image_on_first(model, stretch, s2));
    };
    std::vector<Span> by_s2;
    add_spans([&](double s2) { return gap_at(own, s2) - gap_at(other, s2); }, low, high, model.same, by_s2);
    for (const Span& span : by_s2)  // s1 runs opposite to s2
        spans.push_back({image_on_first(model, own, span.end), image_on_first(model, own, span.begin)});
}

FacingStretch cut_to(const FacingModel& model, const FacingStretch& stretch, double begin, double end) {
    FacingStretch cut = stretch;
    if (begin > stretch.begin.s1) cut.begin = *pair_on_edges(model, stretch.edge1, stretch.edge2, begin);
    if (end < stretch.end.s1) cut.end = *pair_on_edges(model, stretch.edge1, stretch.edge2, end);
    return cut;
}

void add_remainder(const FacingModel& model, const FacingStretch& stretch, std::vector<Span> removed,
                   std::vector<FacingStretch>& kept) {
    std::sort(removed.begin(), removed.end(), [](const Span& a, const Span& b) { return a.begin < b.begin; });
    double from = stretch.begin.s1;
    for (const Span& span : removed) {
        if (span.begin - from > model.same) kept.push_back(cut_to(model, stretch, from, span.begin));
        from = std::max(from, span.end);
    }
    if (stretch.end.s1 - from > model.same) kept.push_back(cut_to(model, stretch, from, stretch.end.s1));
}

}  // namespace

std::vector<FacingStretch> nearest_only(const FacingModel& model, const std::vector<FacingStretch>& stretches) {
    std::map<int, std::vector<std::size_t>> on_edge1, on_edge2;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        on_edge1[stretches[i].edge1].push_back(i);
        on_edge2[stretches[i].edge2].push_back(i);
    }
    std::vector<FacingStretch> kept;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const FacingStretch& own = stretches[i];
        std::vector<Span> removed;
        for (const std::size_t k : on_edge1[own.edge1])
            if (k != i) beaten_on_first(model, own, stretches[k], removed);
        for (const std::size_t k : on_edge2[own.edge2])
            if (k != i) beaten_on_second(model, own, stretches[k], removed);
        add_remainder(model, own, removed, kept);
    }
    return kept;
}

}  // namespace abut::geometry
