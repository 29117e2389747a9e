// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothed stresses: a spline that fits the stresses of the displacement at the points where those are most accurate, by least
// squares [Grishin10, eqs 4.39-4.40]. Its degree is one less than the displacement's; of degrees 1 and 2 the same, where the
// Gauss points weigh most: their stresses converge like h^p there, a whole order better than elsewhere.
#pragma once
#include <memory>
#include <vector>

#include "solver/parts/part_system.hpp"
#include "solver/splines/local_spline.hpp"
#include "src/base/once.hpp"

namespace abut::solver {

/// A place where stresses are sampled.
struct SamplePoint {
    int element;
    Vec2 x;
};

/// A smoothed stress field: a spline for each component.
struct StressField {
    std::shared_ptr<const SplineSpace> space{};  ///< none where nothing is fitted
    Eigen::MatrixX3d coefficients{};             ///< (n_functions x (xx, yy, xy))
    double out_of_plane = 0;                     ///< zz = out_of_plane (xx + yy), where it has
    Eigen::VectorXd zz{};                        ///< no coefficients of its own (has_own_zz)
    std::string failure;
};

/// What the fits of several displacements of one part have in common: the spline, and the factor of its equations.
struct StressFitFactor {
    std::shared_ptr<const SplineSpace> space;
    Factorization factor;
    bool has_rules = false;  ///< quadrature points are sampled, too
};

/// Fits a spline to the stresses of a displacement; a fit that fails says so in `failure`. inside: lines of the sample points
/// of a full cell on [0, 1] (Gauss points of order p - 1; the corners are added here); cut: sample points of the cut cells,
/// inside the part or on its boundary. Where they leave a function open (parts of few cells, all cut), the quadrature points of
/// the cut cells are sampled, too. common: of fits with the same samples of the same part, made by the first; null: of this one
/// alone.
StressField fit_stress(const PartInput& input, const Eigen::VectorXd& displacement, const std::vector<double>& inside,
                       const std::vector<SamplePoint>& cut, const Once<StressFitFactor>* common = nullptr);

/// The stress (xx, yy, xy) on one element of a field whose fit has not failed.
inline LocalSpline<3> local_stress(const StressField& field, int element) {
    return {*field.space, element, [&](int function) { return field.coefficients.row(function).transpose(); }};
}

/// The stress (xx, yy, xy, zz) at a point of an element; not numbers where the fit has failed.
Eigen::Vector4d stress_at(const StressField& field, int element, const Vec2& x);
/// The stress (xx, yy, xy, zz) where local_stress(field, element) is at hand; of fields without a failure.
Eigen::Vector4d stress_at(const StressField& field, const LocalSpline<3>& in_plane, int element, const Vec2& x);

}  // namespace abut::solver
