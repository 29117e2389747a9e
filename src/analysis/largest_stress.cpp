// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/largest_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/linear_algebra/parallel_for.hpp"
#include "solver/terms/stress.hpp"
#include "src/analysis/singular_places.hpp"
#include "src/analysis/stress_error.hpp"
#include "src/answers/field_results.hpp"
#include "src/base/index.hpp"
#include "src/discretization/grid_design.hpp"

namespace abut {

namespace {

constexpr double rounding_of_strain = 1e-11;  // of displacement over size
constexpr double cells_from_corner = 2;       // a largest stress no farther from a corner is the corner's
constexpr double smaller_cells = 10;          // on which stress at a corner is compared with the largest one
constexpr double half_a_cell = 0.5;           // over which an error of strains adds up, before it changes sign

/// von Mises stresses in an element, the largest of each.
struct StressByElement {
    double smoothed = 0;
    double missing = 0;  ///< of what the smoothed stresses and those of the displacement differ by
};

/// Smoothed stresses and those of the displacement at the same place, as von Mises stresses.
class StressesAt {
public:
    StressesAt(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress)
        : input_(grid.input), raw_(grid.input, displacement), stress_(stress) {}

    /// The larger of what is there and of this place.
    void extend(StressByElement& all, int element, const Vec2& x) const {
        const Eigen::Vector4d smoothed = stress_at(stress_, element, x);
        all.smoothed = std::max(all.smoothed, von_mises_of(smoothed.head<3>(), smoothed[3]));
        const double raw_zz = has_own_zz(input_) ? raw_.zz(element, x) : 0;
        all.missing = std::max(all.missing, von_mises_of(smoothed.head<3>() - raw_(element, x), smoothed[3] - raw_zz));
    }

private:
    /// own_zz: where the stress out of the plane does not follow from the others.
    double von_mises_of(const Eigen::Vector3d& s, double own_zz) const {
        return von_mises({s[0], s[1], s[2], has_own_zz(input_) ? own_zz : input_.elasticity.out_of_plane * (s[0] + s[1])});
    }

    const solver::PartInput& input_;
    const solver::StressOf raw_;
    const solver::StressField& stress_;
};

/// The largest missing at a place and at the quadrature points of its element. At one point they may agree by chance.
double smoothing_around(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress,
                        int element, const Vec2& place) {
    const StressesAt stresses(grid, displacement, stress);
    StressByElement largest;
    stresses.extend(largest, element, place);
    for_all_cells(grid.input, [&](const solver::CellRule& cell) {
        if (cell.element == element)
            for (const Vec2& x : cell.points) stresses.extend(largest, element, x);
    });
    return largest.missing;
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

/// Does the stress fall away from a corner, in the mean by half at least of what one without limit falls by? Fields that loads
/// on both of its edges make even do not.
bool falls_away(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress,
                const Vec2& corner, int element, double at_corner, double growth) {
    constexpr double cells_away = 4;
    constexpr int directions = 12;
    const double away = cells_away * grid.cells.grid.box(grid.elements.cell_of(element)).size().maxCoeff();
    double around = 0;
    int inside = 0;
    for (int k = 0; k < directions; ++k) {
        const double angle = 2 * std::numbers::pi * k / directions;
        const Vec2 x = corner + away * Vec2(std::cos(angle), std::sin(angle));
        if (!contains(grid.local, x)) continue;
        const int there = element_at(grid.local, grid.cells, grid.elements, x);
        around += von_mises(sample_field(grid, displacement, stress, there, x).stress);
        ++inside;
    }
    return around > 0 && at_corner > around / inside * std::pow(cells_away, 0.5 * growth);
}

/// Does smoothing change a stress? That of a uniform stress, or of another that the spline has, is one with a limit.
bool is_smoothed(double smoothing, double stress) {
    return smoothing > rounding_of_strain * stress;
}

/// Notes the stress at a corner without a limit that is above the largest one on smaller cells; of several the highest there.
void note_corner(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress,
                 const std::vector<SingularPlace>& places, LargestStress& largest) {
    largest.on_smaller_cells = largest.von_mises.value;
    for (const SingularPlace& p : places) {
        if (p.growth == 0) continue;
        const Vec2 local = grid.frame.to_local(p.at);
        const int element = element_at(grid.local, grid.cells, grid.elements, local);
        const double now = von_mises(sample_field(grid, displacement, stress, element, local).stress),
                     then = now * std::pow(smaller_cells, p.growth);
        if (then <= largest.on_smaller_cells || !falls_away(grid, displacement, stress, local, element, now, p.growth) ||
            !is_smoothed(smoothing_around(grid, displacement, stress, element, local), now))
            continue;
        largest.on_smaller_cells = then;
        largest.corner = ValueAt{now, p.at};
        largest.corner_is_held = p.is_held;
    }
}

/// Is the stress at this place that of one of these, where it has no limit?
bool is_corners(const std::vector<SingularPlace>& places, const Vec2& at, double cell) {
    return std::any_of(places.begin(), places.end(),
                       [&](const SingularPlace& p) { return (p.at - at).norm() <= cells_from_corner * cell; });
}

LargestStress largest_of(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved, std::size_t k,
                         const solver::StressField& stress) {
    const PartOnGrid& grid = solved.grids[k];
    const Eigen::VectorXd& displacement = solved.solution.displacement[k];
    const LargestOfPart found = largest_of_part(grid, displacement, stress);
    LargestStress result;
    result.displacement = found.displacement.value;
    result.von_mises = found.von_mises.value;
    if (found.von_mises.element < 0 || grid.is_rigid) return result;
    const Stress there = result.stress =
        sample_field(grid, displacement, stress, found.von_mises.element, found.von_mises.local).stress;
    const double direct = std::max({std::abs(there.xx), std::abs(there.yy), std::abs(there.zz)}),
                 turned = grid.input.elasticity.d11 * result.displacement.value / grid.size;
    if (result.von_mises.value <= rounding_of_strain * std::max(direct, turned)) return result;
    const auto cell_of = [&](const LargestOfPart::Found& f) {
        return grid.cells.grid.box(grid.elements.cell_of(f.element)).size().maxCoeff();
    };
    if (found.displacement.element >= 0)
        result.displacement_error = half_a_cell * cell_of(found.displacement) *
                                    strain_error(grid.input, displacement, stress, found.displacement.element);
    if (grid.input.stress_free.size() > 0 && found.displacement.element >= 0) {
        // the sides of a cut meet within a cell
        const FieldSample side = sample_field(grid, displacement, stress, found.displacement.element, found.displacement.local);
        result.displacement_error +=
            half_a_cell * cell_of(found.displacement) * von_mises(side.stress) / grid.input.elasticity.d11;
    }
    result.cell = cell_of(found.von_mises);
    const auto places = singular_places(scene, conditions, solved, grid.part);
    result.smoothing = smoothing_around(grid, displacement, stress, found.von_mises.element, found.von_mises.local);
    result.at_corner =
        is_corners(places, result.von_mises.at, result.cell) && is_smoothed(result.smoothing, result.von_mises.value);
    note_corner(grid, displacement, stress, places, result);
    if (result.at_corner) return result;
    const double hidden = hidden_share(grid.local, found.von_mises.local, result.cell);
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
    if (!is_strained(solved)) {
        for (LargestStress& s : all) s.error.reset();
        return all;
    }
    for (std::size_t k = 0; k < all.size() && k < before.size(); ++k)
        if (all[k].error)
            all[k].error =
                std::max(*all[k].error, std::abs(all[k].von_mises.value - before[k].von_mises.value) / all[k].von_mises.value);
    return all;
}

std::vector<int> elements_as_large(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved,
                                   std::size_t k, const solver::StressField& stress, const LargestStress& largest) {
    constexpr double tolerated = 0.01;  // of a stress: what no other grid is worth
    const PartOnGrid& grid = solved.grids[k];
    const StressesAt stresses(grid, solved.solution.displacement[k], stress);
    std::vector<StressByElement> all(grid.input.space.fraction.size());
    for_all_cells(grid.input, [&](const solver::CellRule& cell) {
        for (const Vec2& x : cell.points) stresses.extend(all[at(cell.element)], cell.element, x);
    });
    const auto places = singular_places(scene, conditions, solved, grid.part);
    const auto is_at_corner = [&](int element) {
        const Vec2 size = grid.input.space.cell_size(element),
                   middle = grid.frame.to_global(grid.input.space.low_corner(element) + 0.5 * size);
        return is_corners(places, middle, size.maxCoeff());
    };
    const double as_large = (1 - std::min(largest.error.value_or(0), doubtful)) * largest.von_mises.value;
    std::vector<int> elements;
    for (int e = 0; e < static_cast<int>(all.size()); ++e)
        if (all[at(e)].smoothed >= as_large && all[at(e)].missing > tolerated * all[at(e)].smoothed && !is_at_corner(e))
            elements.push_back(e);
    return elements;
}

const LargestStress* strongest(const std::vector<LargestStress>& all) {
    const LargestStress* most = nullptr;
    for (const LargestStress& s : all)
        if (s.von_mises.value > (most ? most->von_mises.value : 0)) most = &s;
    return most;
}

}  // namespace abut
