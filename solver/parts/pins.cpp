// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/pins.hpp"

#include <algorithm>

namespace abut::solver {

namespace {

using Eigen::Index;

/// A coefficient can be pinned if its stiffness is at least this fraction of the median: one whose function barely touches the
/// part would hold it by a weak spring, and rounding of the loads would move the part (1e-8 of its displacement at degree 3).
constexpr double pin_stiffness_fraction = 0.5;

}  // namespace

std::vector<Index> pins(const PartSystem& s) {
    Eigen::MatrixXd rest = s.modes;
    Eigen::VectorXd diagonal(2 * s.n());
    for (int f = 0; f < s.n(); ++f)
        diagonal.segment<2>(2 * f) =
            s.stiffness.block[static_cast<std::size_t>(s.stiffness.first[static_cast<std::size_t>(f) + 1] - 1)].diagonal();
    std::vector<double> sorted(diagonal.begin(), diagonal.end());
    std::nth_element(sorted.begin(), sorted.begin() + diagonal.size() / 2, sorted.end());
    const double least = pin_stiffness_fraction * sorted[sorted.size() / 2];
    std::vector<Index> chosen;
    for (Index k = 0; k < rest.cols(); ++k) {
        Index best = 0;
        double largest = -1;
        for (Index i = 0; i < rest.rows(); ++i)
            if (!s.dropped[static_cast<std::size_t>(i)] && diagonal[i] >= least && rest.row(i).squaredNorm() > largest) {
                largest = rest.row(i).squaredNorm();
                best = i;
            }
        chosen.push_back(best);
        const Eigen::RowVectorXd pivot = rest.row(best) / rest.row(best).norm();
        rest -= (rest * pivot.transpose()) * pivot;
    }
    return chosen;
}

}  // namespace abut::solver
