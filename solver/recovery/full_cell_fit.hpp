// SPDX-License-Identifier: GPL-3.0-or-later
// The stress fit's normal equations on a full cell: its samples are products of abscissas, so that the B-splines at them are
// done once for every column and row of the grid, and the matrix is a product of theirs.
#pragma once
#include <vector>

#include "solver/terms/stress.hpp"

namespace abut::solver {

/// Abscissas on the unit interval that a full cell's samples are products of: all `inside` of weight 1, all `between` of
/// another.
struct FullCellRule {
    std::vector<double> inside, between;
    double between_weight = 1;
};

/// The normal equations B'WB and B'W s of the fit's functions B on one cell: B-splines in the order of `local_functions`.
struct FullCellEquations {
    Eigen::MatrixXd matrix;
    Eigen::MatrixX3d rhs;
};

/// The equations of full cells: what depends on a column or row alone is done once.
class FullCellFit {
public:
    /// displacement, fit: spaces on the same grid. Cost: O(columns + rows).
    FullCellFit(const SplineSpace& displacement, const SplineSpace& fit, const FullCellRule& rule);

    /// The equations of one full element; stress: on that element, of a part without a structure.
    void equations(const StressOf::OnElement& stress, int element, FullCellEquations& result) const;

private:
    struct Abscissa {
        double at;
        LineValues displacement;
        LocalValues fit;
    };
    struct Samples {
        std::vector<Abscissa> points;
        Eigen::MatrixXd products;  ///< sum of b b' over the points
    };
    struct Line {
        Samples inside, between;
    };
    static Samples samples_on(const IntervalKnots& displacement, const IntervalKnots& fit,
                              const std::vector<double>& abscissas);
    static std::vector<Line> lines_of(const SplineSpace& displacement, const SplineSpace& fit, int axis,
                                      const FullCellRule& rule);
    void add(const StressOf::OnElement& stress, const Samples& x, const Samples& y, double weight,
             FullCellEquations& result) const;

    const SplineSpace& space_;
    double between_weight_;
    std::vector<Line> columns_, rows_;
};

}  // namespace abut::solver
