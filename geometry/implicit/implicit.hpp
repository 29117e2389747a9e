// SPDX-License-Identifier: GPL-3.0-or-later
// Implicit boundaries: functions of the plane that vanish on a part's boundary, for the solution structure u = w Phi + phi
// [Grishin10, eq 3.7]. Not used by the quadrature.
//
// Legend: w value (length; positive inside, zero on the boundary, negative outside, unless said otherwise). Fields are
// normalised to first order: on regular points of the boundary the derivative along the inward normal is 1. At corners the
// value is 0 and the derivatives do not exist: they come back not finite. On the boundary itself fields that have a kink there
// give the derivatives of the material's side.
#pragma once
#include <memory>
#include <vector>

#include "geometry/brep/part.hpp"
#include "geometry/csg/csg.hpp"

namespace abut::geometry {

/// A field's value at a point with its first and second derivatives.
struct FieldValue {
    double value = 0;
    Vec2 gradient{0, 0};
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
};

class FieldShape;

/// A function of the plane. Immutable; copies share what is behind. Evaluation is free of side effects and may run in several
/// threads.
struct ImplicitField {
    std::shared_ptr<const FieldShape> shape;
};

/// The value of a field at p.
double value(const ImplicitField& field, const Vec2& p);
/// Value, gradient and Hessian of a field at p, exact (automatic differentiation; closest points of splines: closed forms at
/// the foot).
FieldValue evaluate(const ImplicitField& field, const Vec2& p);

/// R-functions of fields (r_functions.hpp). More than two are joined in a balanced tree, neighbours first: depth log n.
ImplicitField conjunction(const std::vector<ImplicitField>& fields, double alpha = 0);
ImplicitField disjunction(const std::vector<ImplicitField>& fields, double alpha = 0);
ImplicitField negation(const ImplicitField& field);
/// The field (sum |w_i|^-m)^(-1/m): zero where one of the fields is.
ImplicitField equivalence(const std::vector<ImplicitField>& fields, int m);

/// The R-function of a geometry tree: half planes, circles, ellipses and rectangles (four half planes) in closed form, slots,
/// polygons, loops and imports as distance_field with m = leaf_join_order. alpha in (-1, 1]. Placements move the primitives'
/// edges, so the field stays normalised under scaling. The sign is the tree's set membership; alpha = 1 has kinks inside.
/// Where boundaries of two primitives coincide the field is not normalised, and zero inside unions of bodies that abut
/// (r_functions.hpp): distance_field of the evaluated part has neither fault.
/// Throws std::logic_error for trees in which primitives_of finds problems. Cost of a point: O(edges of all primitives).
ImplicitField implicit_of(const CsgNode& tree, double alpha = 0);
inline constexpr int leaf_join_order = 2;

/// The field of a part out of its edges: trimmed_edge.hpp's fields joined by (sum w_i^-m)^(-1/m), with the sign by contains().
/// Zero on the edges only. m >= 1; even m are smooth away from corners, except across the medial axis of a spline edge and
/// where the closest point of a spline becomes one of its ends (the gradient is continuous there, the Hessian jumps). Cost of a
/// point: O(edges), and a search for the closest point on each spline.
ImplicitField distance_field(const Part& part, int m);

/// The field of some edges of a part (Dirichlet edges): zero on them, positive elsewhere, on both sides of the boundary; on the
/// edges the derivatives are those of the material's side. Throws std::logic_error if `edges` is empty or names none.
ImplicitField edge_field(const Part& part, const std::vector<int>& edges, int m);

/// The field of the whole line, circle or ellipse that a curve lies on [Grishin10, eq 4.13], positive on the curve's left; of a
/// spline, which lies on nothing else, the distance, positive on both sides. Legend as above.
ImplicitField whole_field(const Curve& curve);

/// A field that is zero in the given points, positive elsewhere: squared distances, conjoined [Grishin10, eqs 4.14-4.16]. In
/// length^2, with a vanishing gradient in the points. The dissertation nests the conjunctions in another order for more than
/// two points.
ImplicitField point_field(const std::vector<Vec2>& points, double alpha = 0);

/// Points closer to an edge than this fraction of the part's diagonal count as on it: their sign there is the edge's own,
/// since that of contains() is open to rounding.
inline constexpr double on_edge_fraction = 1e-12;

}  // namespace abut::geometry
