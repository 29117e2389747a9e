// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/pins.hpp"

#include <algorithm>

namespace abut::solver {

namespace {

using Eigen::Index;

/// A coefficient can be pinned if its stiffness is at least this fraction of the median: one whose function barely touches the
/// part would hold it by a weak spring, and rounding of the loads would move the part (1e-8 of its displacement at degree 3).
constexpr double pin_stiffness_fraction = 0.5;

/// The functions that are one at a corner of the grid. A point of the part that is held there is their coefficient alone:
/// pinned, it would yield to no force, and its row of the compliance would be zero.
std::vector<char> corner_functions(const SplineSpace& space) {
    constexpr double whole = 1 - 1e-9;
    std::vector<char> is_corner(static_cast<std::size_t>(space.n_functions), 0);
    for (const double x : {space.x.breakpoints.front(), space.x.breakpoints.back()})
        for (const double y : {space.y.breakpoints.front(), space.y.breakpoints.back()}) {
            const int cell = space.cell_at({x, y});
            if (space.fraction[static_cast<std::size_t>(cell)] == 0) continue;
            const PointBasis basis = evaluate(space, cell, {x, y});
            for (std::size_t k = 0; k < basis.functions.size(); ++k)
                if (basis.value[static_cast<Index>(k)] > whole) is_corner[static_cast<std::size_t>(basis.functions[k])] = 1;
        }
    return is_corner;
}

Eigen::VectorXd diagonal_of(const PartSystem& s) {
    Eigen::VectorXd diagonal(2 * s.n());
    for (int f = 0; f < s.n(); ++f)
        diagonal.segment<2>(2 * f) =
            s.stiffness.block[static_cast<std::size_t>(s.stiffness.first[static_cast<std::size_t>(f) + 1] - 1)].diagonal();
    return diagonal;
}

double median_of(const Eigen::VectorXd& numbers) {
    std::vector<double> sorted(numbers.begin(), numbers.end());
    std::nth_element(sorted.begin(), sorted.begin() + numbers.size() / 2, sorted.end());
    return sorted[sorted.size() / 2];
}

}  // namespace

std::vector<Index> pins(const PartSystem& s, const Eigen::MatrixXd& motions) {
    Eigen::MatrixXd rest = motions;
    const Eigen::VectorXd diagonal = diagonal_of(s);
    const double least = pin_stiffness_fraction * median_of(diagonal);
    const std::vector<char> is_corner = corner_functions(s.input.space);
    constexpr double of_corner = 1e-6;  // last choice: of splines of degree 1 there may be no others
    const auto size = [&](Index i) {
        return rest.row(i).squaredNorm() * (is_corner[static_cast<std::size_t>(i / 2)] ? of_corner : 1);
    };
    std::vector<Index> chosen;
    for (Index k = 0; k < rest.cols(); ++k) {
        Index best = 0;
        double largest = -1;
        for (Index i = 0; i < rest.rows(); ++i)
            if (!s.dropped[static_cast<std::size_t>(i)] && diagonal[i] >= least && size(i) > largest) {
                largest = size(i);
                best = i;
            }
        chosen.push_back(best);
        const Eigen::RowVectorXd pivot = rest.row(best) / rest.row(best).norm();
        rest -= (rest * pivot.transpose()) * pivot;
    }
    return chosen;
}

double median_stiffness(const PartSystem& s) {
    return median_of(diagonal_of(s));
}

}  // namespace abut::solver
