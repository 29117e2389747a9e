// SPDX-License-Identifier: GPL-3.0-or-later
// Results made up from formulas, to test what is written about a result without solving anything.
#pragma once
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "src/results/result.hpp"

namespace abut::synthetic {

inline geometry::Part rectangle(const std::string& name, const Vec2& min, const Vec2& max) {
    const Vec2 b(max.x(), min.y()), d(min.x(), max.y());
    geometry::Part part;
    part.name = name;
    part.edges = {{geometry::Segment{min, b}, "bottom", "bottom"},
                  {geometry::Segment{b, max}, "right", "right"},
                  {geometry::Segment{max, d}, "top", "top"},
                  {geometry::Segment{d, min}, "left", "left"}};
    part.loops = {{{0, 1, 2, 3}}};
    return part;
}

inline geometry::Part disc(const std::string& name, const Vec2& center, double radius) {
    geometry::Part part;
    part.name = name;
    part.edges = {{geometry::Arc{center, radius, 0, 2 * std::numbers::pi}, "circle", "circle"}};
    part.loops = {{{0}}};
    return part;
}

inline void add_hole(geometry::Part& part, const Vec2& center, double radius) {
    const int edge = static_cast<int>(part.edges.size());
    part.edges.push_back({geometry::Arc{center, radius, 0, -2 * std::numbers::pi}, "hole", "hole", false});
    part.loops.push_back({{edge}});
}

/// Displacement and stress at a point.
using Formula = std::function<FieldSample(const Vec2&)>;

/// A field on a regular grid of n x n patches over the part's box, which reaches beyond the part as boundary cells do.
inline PartField field(const geometry::Part& part, int n, const Formula& formula) {
    PartField made;
    const geometry::Box2 box = geometry::bounding_box(part);
    const Vec2 step = 1.02 * box.size() / n, origin = box.min - 0.01 * box.size();
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) made.samples.push_back(formula(origin + Vec2(i * step.x(), j * step.y())));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int k = j * (n + 1) + i;
            made.patches.push_back({{k, k + 1, k + n + 2, k + n + 1}});
        }
    for (const geometry::Loop& loop : part.loops) {
        std::vector<FieldSample> points;
        for (int e : loop.edges)
            for (int i = 0; i < 48; ++i)
                points.push_back(formula(geometry::point(part.edges[static_cast<std::size_t>(e)].curve, i / 48.0)));
        made.boundary.push_back(points);
    }
    return made;
}

/// Adds the part with the field, and the maxima of the field's samples inside it.
inline void add_part(Result& result, const geometry::Part& part, const std::string& material, int n, const Formula& formula) {
    PartResult made;
    made.name = part.name;
    made.material = material;
    made.area = geometry::area(part);
    made.unknowns = 2 * (n + 2) * (n + 2);
    made.cells_inner = n * n / 2;
    made.cells_boundary = 4 * n;
    made.cells_outer = n;
    const geometry::Box2 box = geometry::bounding_box(part);
    for (int i = 0; i <= n; ++i) {
        made.grid_x.push_back(box.min.x() + box.size().x() * i / n);
        made.grid_y.push_back(box.min.y() + box.size().y() * i / n);
    }
    const PartField drawn = field(part, n, formula);
    for (const FieldSample& s : drawn.samples) {
        if (!geometry::contains(part, s.at)) continue;
        if (s.displacement.norm() > made.max_displacement.value) made.max_displacement = {s.displacement.norm(), s.at};
        if (von_mises(s.stress) > made.max_von_mises.value) made.max_von_mises = {von_mises(s.stress), s.at};
    }
    result.geometry.push_back(part);
    result.parts.push_back(made);
    result.fields.push_back(drawn);
}

/// A half-ellipse of pressure over the arc of a circle from angle a0 to a1, on part 0's edge; candidates reach 30 % farther.
inline ContactResult arc_contact(const Result& result, int first, int second, const Vec2& center, double radius, double a0,
                                 double a1, double peak) {
    ContactResult c;
    c.part = {first, second};
    const auto name = [&](int i) { return result.parts[static_cast<std::size_t>(i)].name; };
    c.parts = {name(first), name(second)};
    c.between = {c.parts[0] + "/hole", c.parts[1] + "/circle"};
    c.edges = {{{c.between[0]}, {c.between[1]}}};
    c.interface = "pin-in-hole";
    c.status = peak > 0 ? "partial" : "open";
    c.gap_max = 0.01 * radius;
    c.force = {0, -peak * radius * (a1 - a0) / 2};
    const double middle = (a0 + a1) / 2, half = (a1 - a0) / 2;
    const auto on = [&](double angle) { return Vec2(center + radius * Vec2(std::cos(angle), std::sin(angle))); };
    for (int i = 0; i <= 60; ++i) {
        const double u = 1.3 * (i / 30.0 - 1), angle = middle + u * half;
        c.profile.edge.push_back(c.between[0]);
        c.profile.s.push_back(radius * angle);
        c.profile.x.push_back(on(angle).x());
        c.profile.y.push_back(on(angle).y());
        c.profile.pressure.push_back(std::abs(u) < 1 ? peak * std::sqrt(1 - u * u) : 0);
        c.profile.gap.push_back(std::abs(u) < 1 ? 0 : 0.01 * radius * (std::abs(u) - 1));
    }
    c.profile.edge2 = std::vector<std::string>(c.profile.edge.size(), c.between[1]);
    c.profile.s2 = c.profile.s;
    c.profile.x2 = c.profile.x;
    c.profile.y2 = c.profile.y;
    c.max_pressure = {peak, on(middle)};
    c.error_estimate = 0.03;
    if (peak > 0) {
        c.contact_length = radius * (a1 - a0);
        c.ends = {on(a0), on(a1)};
    }
    return c;
}

/// Stress that decays from a point, displacement that bends; for parts about as large as `size`.
inline Formula decaying(const Vec2& from, double size, double stress, double displacement) {
    return [=](const Vec2& p) {
        const double r = (p - from).norm() / size;
        FieldSample s;
        s.at = p;
        s.displacement = displacement * Vec2(0.2 * std::sin(3 * p.y() / size), -std::exp(-r));
        s.stress = {-stress / (1 + 20 * r * r), -1.8 * stress / (1 + 8 * r * r), 0.3 * stress * (p - from).x() / size / (1 + r),
                    0};
        return s;
    };
}

/// A bracket with a hole, and a pin in it that pulls down; `unit` is the length of one millimetre in the scene's unit.
inline Result bracket(double unit = 1) {
    Result r;
    r.title = "Pin in a bracket";
    r.length_unit = unit == 1 ? "mm" : "m";
    r.force_unit = "N";
    const Vec2 center(0, 60 * unit);
    geometry::Part plate = rectangle("bracket", {-40 * unit, 0}, {40 * unit, 100 * unit});
    add_hole(plate, center, 20 * unit);
    const double stress = 120 / unit / unit;
    const Vec2 bottom = center - Vec2(0, 20 * unit);
    add_part(r, plate, "aluminium", 40, decaying(bottom, 60 * unit, stress, 0.02 * unit));
    add_part(r, disc("pin", center, 19.9 * unit), "steel", 30, decaying(bottom, 40 * unit, stress, 0.03 * unit));
    r.contacts.push_back(
        arc_contact(r, 0, 1, center, 20 * unit, 1.2 * std::numbers::pi, 1.8 * std::numbers::pi, 132.4 / unit / unit));
    for (int i = 0; i <= 40; ++i) r.support_marks.push_back({Vec2((-40 + 2 * i) * unit, 0), Vec2(0, -1), true, true});
    for (int i = 0; i <= 10; ++i) r.support_marks.push_back({Vec2(-40 * unit, (10 + 2 * i) * unit), Vec2(-1, 0), true, false});
    r.load_marks = {{center, Vec2(0, -1)}};
    for (int i = 0; i <= 8; ++i) r.load_marks.push_back({Vec2((-40 + 10 * i) * unit, 100 * unit), Vec2(0, 1)});
    r.unknowns = 3528;
    r.multipliers = 24;
    r.cells = {1250, 280, 70};
    r.solver.grids = 2;
    r.solver.factorizations = 4;
    r.solver.contact_iterations = 7;
    r.solver.condition_estimate = 1.3e3;
    r.timing = {{"import", 0.002},   {"geometry", 0.011}, {"assembly", 0.021}, {"solve", 0.032},
                {"recovery", 0.012}, {"output", 0.004},   {"total", 0.082}};
    r.effects = {{"contact", true, "2 parts touch at 1 place", 0.03}, {"temperature", false, "no temperature load", 0}};
    r.strain_energy = 12.75;
    r.equilibrium.applied = {0, -1000};
    r.equilibrium.reaction = {1.2e-12, 1000};
    r.equilibrium.relative_residual = 3.1e-13;
    r.equilibrium.relative_moment_residual = 2e-13;
    r.error_estimate.contact_pressure = 0.03;
    r.error_estimate.method = "change between the last two grids";
    r.reactions = {{0, "fix x, y on bracket/bottom", "aligned", {0, 1000}, 0},
                   {1, "fix x on bracket/left", "nitsche", {1e-12, 0}, 4.5}};
    r.probes = {{"bracket",
                 {0, 20 * unit},
                 {1e-4 * unit, -0.012 * unit},
                 {1.5 / unit / unit, -20.25 / unit / unit, 0.5 / unit / unit, 0}}};
    return r;
}

}  // namespace abut::synthetic
