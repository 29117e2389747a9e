// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/largest_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/linear_algebra/parallel_for.hpp"
#include "solver/terms/stress.hpp"
#include "src/answers/field_results.hpp"
#include "src/discretization/grid_design.hpp"

namespace abut {

namespace {

constexpr double sharp_turn = 0.1;       // radians, as for the cells at re-entrant corners (grid_design)
constexpr double cells_from_corner = 2;  // a largest stress no farther from a corner is the corner's

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// A vertex of a part: where an edge ends and the next one begins.
struct Vertex {
    int edge, next;
    Vec2 at;
    double turn;  ///< to the left; re-entrant: negative
};

std::vector<Vertex> vertices(const geometry::Part& part) {
    std::vector<Vertex> all;
    for (const geometry::Loop& loop : part.loops)
        for (std::size_t i = 0; i < loop.edges.size(); ++i) {
            const int edge = loop.edges[i], next = loop.edges[(i + 1) % loop.edges.size()];
            const Vec2 from = unit_tangent(part.edges[at(edge)].curve, 1), to = unit_tangent(part.edges[at(next)].curve, 0);
            all.push_back(
                {edge, next, point(part.edges[at(edge)].curve, 1), std::atan2(geometry::cross(from, to), from.dot(to))});
        }
    return all;
}

/// Holds both components where it holds one?
bool is_clamp(const Support& support) {
    return (support.kind == Support::Kind::fix || support.kind == Support::Kind::displacement) && support.x && support.y;
}

/// Stress has a limit where a support ends at a corner of at most a right angle and the part slides along it (there the support
/// is a plane of symmetry of a smooth boundary), and where another support goes on; else it has none.
void append_support_ends(const Scene& scene, const ResolvedConditions& conditions, int part, std::vector<Vec2>& places) {
    struct End {
        Vec2 at;
        bool is_limited;
        int portions;
    };
    const geometry::Part& shape = scene.parts[at(part)].part;
    const double merge = merge_length(shape);
    const std::vector<Vertex> corners = vertices(shape);
    std::vector<End> ends;
    for (std::size_t s = 0; s < conditions.supports.size(); ++s) {
        if (scene.supports[s].kind == Support::Kind::spring) continue;
        for (const EdgePortion& portion : conditions.supports[s]) {
            if (portion.part != part) continue;
            for (double t : {portion.t0, portion.t1}) {
                const Vec2 place = point(shape.edges[at(portion.edge)].curve, t);
                const auto is_here = [&](const auto& other) { return (other.at - place).norm() <= merge; };
                const auto vertex = std::find_if(corners.begin(), corners.end(), is_here);
                const double right_angle = 0.5 * std::numbers::pi - 1e-3;
                const bool is_limited = !is_clamp(scene.supports[s]) && vertex != corners.end() && vertex->turn >= right_angle;
                const auto known = std::find_if(ends.begin(), ends.end(), is_here);
                if (known == ends.end())
                    ends.push_back({place, is_limited, 1});
                else
                    ++known->portions;
            }
        }
    }
    for (const End& end : ends)
        if (!end.is_limited && end.portions == 1) places.push_back(end.at);
}

/// Where stress of a part has no limit, in assembly coordinates.
std::vector<Vec2> places_without_limit(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved,
                                       int part) {
    std::vector<Vec2> places;
    for (const Vertex& v : vertices(scene.parts[at(part)].part))
        if (v.turn < -sharp_turn) places.push_back(v.at);
    append_support_ends(scene, conditions, part, places);
    for (const Support& s : scene.supports)
        if (s.kind == Support::Kind::points && s.part == scene.parts[at(part)].name)
            places.insert(places.end(), s.at.begin(), s.at.end());
    for (std::size_t k = 0; k < solved.runs.size(); ++k) {
        const ContactInterface& contact = solved.contacts[k];
        for (int side : {0, 1}) {
            if (contact.part[at(side)] != part) continue;
            for (const ContactRun& run : solved.runs[k])
                for (const auto& [end, s] : {std::pair(run.at_begin, run.begin), std::pair(run.at_end, run.end)}) {
                    if (end.kind != RunEnd::Kind::corner) continue;
                    const geometry::FacingPair pair = pair_at(scene, contact, s);
                    places.push_back(side == 0 ? pair.on1.x : pair.on2.x);
                }
        }
    }
    return places;
}

/// von Mises stress of what the smoothed stress and that of the displacement differ by: the largest at a place and at the
/// quadrature points of its element. At one point they may agree by chance.
double smoothing_around(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress,
                        int element, const Vec2& place) {
    const solver::StressOf raw(grid.input, displacement);
    double largest = 0;
    const auto take = [&](const Vec2& x) {
        const Eigen::Vector4d smoothed = stress_at(stress, element, x);
        const Eigen::Vector3d s = smoothed.head<3>() - raw(element, x);
        const double zz =
            has_own_zz(grid.input) ? smoothed[3] - raw.zz(element, x) : grid.input.elasticity.out_of_plane * (s[0] + s[1]);
        largest = std::max(largest, von_mises({s[0], s[1], s[2], zz}));
    };
    take(place);
    for_all_cells(grid.input, [&](const solver::CellRule& cell) {
        if (cell.element == element) std::for_each(cell.points.begin(), cell.points.end(), take);
    });
    return largest;
}

/// What a cell does not see of a notch whose radius is below its size, of the stress there: notches as deep as the cell raise
/// the stress by 1 + 2 sqrt(depth / radius) (Inglis).
double hidden_share(const geometry::Part& local, const Vec2& place, double cell) {
    geometry::Box2 near;
    near.extend(Vec2(place - Vec2::Constant(cell)));
    near.extend(Vec2(place + Vec2::Constant(cell)));
    const double radius = reentrant_radius(local, near);
    return radius < cell ? 1 - 1 / (1 + 2 * std::sqrt(cell / radius)) : 0;
}

LargestStress largest_of(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved, std::size_t k,
                         const solver::StressField& stress) {
    const PartOnGrid& grid = solved.grids[k];
    const Eigen::VectorXd& displacement = solved.solution.displacement[k];
    const LargestOfPart found = largest_of_part(grid, displacement, stress);
    LargestStress result;
    result.displacement = found.displacement;
    result.von_mises = found.von_mises;
    if (found.element < 0 || grid.is_rigid) return result;
    const geometry::Grid& lines = grid.cells.grid;
    const int cell = grid.elements.cell_of(found.element);
    const auto i = at(lines.column_of(cell)), j = at(lines.row_of(cell));
    result.cell = std::max(lines.x[i + 1] - lines.x[i], lines.y[j + 1] - lines.y[j]);
    const auto places = places_without_limit(scene, conditions, solved, grid.part);
    result.at_corner = std::any_of(places.begin(), places.end(), [&](const Vec2& p) {
        return (p - result.von_mises.at).norm() <= cells_from_corner * result.cell;
    });
    result.smoothing = smoothing_around(grid, displacement, stress, found.element, found.local);
    if (result.at_corner) return result;
    const double hidden = hidden_share(grid.local, found.local, result.cell);
    result.error = std::max(result.smoothing / result.von_mises.value, hidden);
    return result;
}

}  // namespace

std::vector<LargestStress> largest_stresses(const Scene& scene, const ResolvedConditions& conditions,
                                            const SolvedAssembly& solved, const std::vector<solver::StressField>& stress,
                                            const std::vector<LargestStress>& before, int threads) {
    std::vector<LargestStress> all(solved.grids.size());
    solver::parallel_for(static_cast<int>(all.size()), threads, [&](int i) {
        if (stress[at(i)].failure.empty()) all[at(i)] = largest_of(scene, conditions, solved, at(i), stress[at(i)]);
    });
    for (std::size_t k = 0; k < all.size() && k < before.size(); ++k)
        if (all[k].error)
            all[k].error =
                std::max(*all[k].error, std::abs(all[k].von_mises.value - before[k].von_mises.value) / all[k].von_mises.value);
    return all;
}

const LargestStress* strongest(const std::vector<LargestStress>& all) {
    const LargestStress* most = nullptr;
    for (const LargestStress& s : all)
        if (s.von_mises.value > (most ? most->von_mises.value : 0)) most = &s;
    return most;
}

}  // namespace abut
