// SPDX-License-Identifier: GPL-3.0-or-later
// Euler's stress of a column of length L and thickness t that is pinned at both ends is pi^2 E t^2 / (12 L^2); held at one end
// only it is a quarter of that, clamped at both ends four times as much. The hoop stress of a ring of middle radius R under
// pressure from outside is at most E t^2 / (4 R^2), of pressures of 3 E I / R^3 [Timoshenko61, chapter 7]. Its mean is that of
// both normal stresses together.
#include "src/analysis/slender_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "solver/terms/finite_motion.hpp"
#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

constexpr double across_column = 0.5;  // cosine: what points more along a column is at its ends

struct Column {
    Vec2 along{0, 0};        ///< between the ends that are farthest apart; parts with holes are none
    double slenderness = 0;  ///< thickness over length
};

Column column_of(const geometry::Part& part) {
    Column column;
    if (part.loops.size() != 1) return column;
    double perimeter = 0;
    for (const geometry::Edge& a : part.edges) {
        perimeter += length(a.curve);
        for (const geometry::Edge& b : part.edges)
            if (const Vec2 d = point(b.curve, 0) - point(a.curve, 0); d.norm() > column.along.norm()) column.along = d;
    }
    if (column.along.norm() > 0) column.slenderness = 2 * area(part) / perimeter / column.along.norm();
    return column;
}

/// Thickness over middle radius of a part that is a ring, nearly round outside and inside; 0: it is none.
double ring_slenderness(const geometry::Part& part) {
    constexpr double round = 0.95;  // of the area that a circle of this length has; regular hexagons have 0.907
    if (part.loops.size() != 2) return 0;
    double perimeter = 0;
    for (const geometry::Loop& loop : part.loops) {
        geometry::Part outline;
        for (const int e : loop.edges) outline.edges.push_back(part.edges[at(e)]);
        const double length = geometry::perimeter(outline);
        if (4 * std::numbers::pi * std::abs(area(outline)) < round * length * length) return 0;
        perimeter += length;
    }
    const double thickness = 2 * area(part) / perimeter, radius = perimeter / (4 * std::numbers::pi);
    return thickness / radius;
}

/// A part's mean stress, in its grid's frame.
Eigen::Matrix2d mean_stress(const SolvedAssembly& solved, std::size_t grid) {
    const solver::PartInput& input = solved.problem.parts[grid].input;
    return stress_integral(input, solved.solution.displacement[grid]) / (solved.grids[grid].area * input.thickness);
}

/// The stress along a direction, in assembly coordinates.
double stress_along(const PartOnGrid& g, const Eigen::Matrix2d& stress, const Vec2& along) {
    const Vec2 e = g.frame.vector_to_local(along.normalized());
    return e.dot(stress * e);
}

/// Is a part bonded to others along as much of its boundary as half of a length? Its sides do not give way then.
bool is_bonded_along(const SolvedAssembly& solved, std::size_t grid, double along) {
    double bonded = 0;
    for (const ContactInterface& c : solved.contacts)
        if (c.face.bilateral && !c.s.empty() && (at(c.face.part[0]) == grid || at(c.face.part[1]) == grid))
            bonded += c.s.back() - c.s.front();
    return bonded >= 0.5 * along;
}

/// Do supports hold a column against moving aside along half of its length?
bool is_held_along(const SolvedAssembly& solved, std::size_t grid, const Vec2& along) {
    const PartOnGrid& g = solved.grids[grid];
    const Vec2 axis = g.frame.vector_to_local(along.normalized());
    double held = 0;
    for (const solver::SupportRecord& record : solved.problem.parts[grid].supports) {
        const solver::SupportSet& set = record.set;
        if (!set.side)
            for (const solver::SupportPoint& p : set.points)
                held += std::abs(axis.dot(p.direction)) <= across_column ? p.weight : 0;
        else if (std::abs(axis[set.component]) <= across_column)
            for (const solver::Stretch& stretch : set.stretches) held += stretch.to - stretch.from;
    }
    return held >= 0.5 * along.norm();
}

/// Is a part pressed between others from both of its long sides, along half of its length at least? So is a gasket.
bool is_pressed_between(const Scene& scene, const SolvedAssembly& solved, std::size_t grid, const Vec2& along) {
    const Vec2 axis = along.normalized();
    std::array<double, 2> pressed{0, 0};  // by side
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        for (std::size_t of : {0U, 1U})
            for (const PressedStretch& stretch : solved.stretches[k]) {
                const ContactInterface& c = solved.contacts[k];
                if (at(c.face.part[of]) != grid) continue;
                const geometry::FacingPair pair = pair_at(scene, c, 0.5 * (stretch.begin + stretch.end));
                const Vec2 normal = of == 0 ? pair.on1.normal : pair.on2.normal;
                if (!pair.found || std::abs(normal.dot(axis)) > across_column) continue;
                pressed[geometry::cross(axis, normal) > 0 ? 0 : 1] += stretch.end - stretch.begin;
            }
    return std::min(pressed[0], pressed[1]) >= 0.5 * along.norm();
}

/// Is a part held along edges, or at more points than keep it in its place, or pressed on others all along half of one of its
/// outlines?
bool is_held_around(const Scene& scene, const SolvedAssembly& solved, std::size_t grid, double outline) {
    constexpr std::size_t in_place = 3;
    std::size_t points = 0;
    for (const Support& s : scene.supports)
        if (s.kind == Support::Kind::points && s.part == scene.parts[at(solved.grids[grid].part)].name) points += s.at.size();
    const std::vector<solver::SupportRecord>& records = solved.problem.parts[grid].supports;
    const auto holds_edges = [&](const solver::SupportRecord& record) {
        const Support::Kind kind = scene.supports[at(record.set.tag)].kind;
        return kind != Support::Kind::points && kind != Support::Kind::rigid;
    };
    if (points > in_place || has_support(scene, Support::Kind::spring) ||
        std::any_of(records.begin(), records.end(), holds_edges))
        return true;
    double pressed = 0;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        if (at(solved.contacts[k].face.part[0]) == grid || at(solved.contacts[k].face.part[1]) == grid)
            for (const PressedStretch& stretch : solved.stretches[k]) pressed += stretch.end - stretch.begin;
    return pressed >= 0.5 * outline;
}

std::optional<Finding> ring_that_buckles(const Scene& scene, const Outcome& out, std::size_t k) {
    const PartOnGrid& g = out.solved.grids[k];
    const ScenePart& part = scene.parts[at(g.part)];
    const double critical = 0.25 * std::pow(ring_slenderness(part.part), 2) * g.input.elasticity.d11;
    if (critical == 0 || out.largest[k].von_mises.value <= critical) return std::nullopt;
    const double outline = 0.5 * perimeter(part.part);
    if (is_bonded_along(out.solved, k, outline) || is_held_around(scene, out.solved, k, outline)) return std::nullopt;
    const double pressed = -mean_stress(out.solved, k).trace();
    constexpr double hoop_alone = 0.75;  // of it is what von Mises' stress is: less is a pressure from inside as well
    if (pressed <= critical || out.largest[k].von_mises.value < hoop_alone * pressed) return std::nullopt;
    return Finding{pressed / critical, part.name,
                   "part " + part.name + " is a thin ring, and pressed around its circumference by " + number_text(pressed, 3) +
                       " on average: such a ring buckles from " + number_text(critical, 3) +
                       " on, unless something holds it round; buckling is not computed",
                   "part " + part.name + " may buckle"};
}

}  // namespace

void warn_of_buckling(const Scene& scene, const Outcome& out, Result& result) {
    if (out.largest.empty()) return;  // failed
    std::vector<Finding> findings;
    for (std::size_t k = 0; k < out.solved.grids.size(); ++k) {
        const PartOnGrid& g = out.solved.grids[k];
        if (g.is_rigid || g.input.structure || g.input.axis || g.input.free_strain) continue;
        const ScenePart& part = scene.parts[at(g.part)];
        if (std::optional<Finding> ring = ring_that_buckles(scene, out, k)) findings.push_back(std::move(*ring));
        const Column column = column_of(part.part);
        const double euler = std::pow(std::numbers::pi * column.slenderness, 2) / 12 * g.input.elasticity.d11;
        const double one_end = 0.25 * euler, both_ends = 4 * euler;
        if (euler == 0 || out.largest[k].von_mises.value <= one_end) continue;
        if (is_bonded_along(out.solved, k, column.along.norm()) || is_held_along(out.solved, k, column.along)) continue;
        const double pressed = -stress_along(g, mean_stress(out.solved, k), column.along);
        if (pressed <= one_end || is_pressed_between(scene, out.solved, k, column.along)) continue;
        const std::string pressed_by =
            "part " + part.name + " is slender, and pressed along its length by " + number_text(pressed, 3) + " on average: ";
        findings.push_back({pressed / euler, part.name,
                            pressed_by + "such a column buckles from " + number_text(one_end, 3) +
                                " on where it is held at one end, from " + number_text(both_ends, 3) +
                                " on where it is clamped at both, unless something holds its sides",
                            pressed > both_ends ? "part " + part.name + " may buckle" : ""});
    }
    tell(std::move(findings), "buckling", result);
}

}  // namespace abut
