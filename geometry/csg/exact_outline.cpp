// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/exact_outline.hpp"

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/variant.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <variant>
#include <vector>

#include "geometry/curves/arc_spline.hpp"

namespace abut::geometry {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using PlaneTraits = CGAL::Arr_circle_segment_traits_2<Kernel>;
using PlaneCurve = PlaneTraits::X_monotone_curve_2;
constexpr int unknown_winding = -1;
/// Every face holds its winding number.
using Arrangement = CGAL::Arrangement_2<PlaneTraits, CGAL::Arr_face_extended_dcel<PlaneTraits, int>>;

Kernel::Point_2 corner_at(const Vec2& p) {
    return {p.x(), p.y()};
}

Vec2 place_of(const PlaneTraits::Point_2& p) {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

/// The monotone piece in what CGAL hands over of an arc that is longer than a point: CGAL 5 wraps it in boost's variant, CGAL 6
/// does not.
template <class Made>
const PlaneCurve& piece_in(const Made& made) {
    if constexpr (std::is_same_v<Made, PlaneCurve>)
        return made;
    else
        return boost::get<PlaneCurve>(made);
}

/// Appends the line or arc from `from` over the middle of `curve` to `to`.
void append(const Curve& curve, const Vec2& from, const Vec2& to, std::vector<PlaneCurve>& outline) {
    const Kernel::Point_2 begin = corner_at(from), end = corner_at(to), middle = corner_at(point(curve, 0.5));
    if (std::holds_alternative<Segment>(curve) || CGAL::collinear(begin, middle, end)) {
        outline.emplace_back(begin, end);
        return;
    }
    const auto take = [&](const auto& made) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(made)>, PlaneTraits::Point_2>) outline.push_back(piece_in(made));
    };
    PlaneTraits().make_x_monotone_2_object()(PlaneTraits::Curve_2(begin, middle, end),
                                             boost::make_function_output_iterator(take));
}

/// Lines and arcs of at most half a turn that follow the curve.
std::vector<Curve> simple_pieces(const Curve& curve, double tolerance) {
    if (const auto* arc = std::get_if<Arc>(&curve); arc && std::abs(arc->sweep) > std::numbers::pi)
        return {trimmed(curve, 0, 0.5), trimmed(curve, 0.5, 1)};
    std::vector<Curve> pieces;
    for (const ArcPiece& piece : arc_spline(curve, tolerance)) pieces.push_back(piece.curve);
    return pieces;
}

std::vector<PlaneCurve> outline_of(const Part& part) {
    const double tolerance = arc_spline_fraction * bounding_box(part).diagonal();
    std::vector<PlaneCurve> outline;
    for (const Loop& loop : part.loops) {
        std::vector<Curve> pieces;
        for (const int e : loop.edges)
            for (Curve& piece : simple_pieces(curve_of(part, e), tolerance)) pieces.push_back(std::move(piece));
        for (std::size_t i = 0; i < pieces.size(); ++i)
            append(pieces[i], point(pieces[i], 0), point(pieces[(i + 1) % pieces.size()], 0), outline);
    }
    return outline;
}

/// Where outlines were cut that should have nothing but corners in common, and how many cuts were found that are none but
/// rounding: two edges that leave a corner along one tangent may cross again next to it.
struct Cuts {
    std::size_t n_rounding = 0;
    std::optional<Vec2> wrong;  ///< the first one, from the left
};

Cuts cuts_of(const Arrangement& arrangement, const Part& part) {
    Cuts cuts;
    const auto from_corner = [&](const Vec2& p) {
        double distance = std::numeric_limits<double>::infinity();
        for (const Edge& edge : part.edges) distance = std::min(distance, (point(edge.curve, 0) - p).norm());
        return distance;
    };
    for (auto vertex = arrangement.vertices_begin(); vertex != arrangement.vertices_end(); ++vertex) {
        if (vertex->degree() == 2) continue;
        const Vec2 p = place_of(vertex->point());
        const double distance = from_corner(p);
        if (distance > 0 && distance <= merge_length(part))
            ++cuts.n_rounding;
        else if (!cuts.wrong || distance > 0)
            cuts.wrong = p;
        if (distance > merge_length(part)) break;
    }
    return cuts;
}

/// Are all corners of the face one but for rounding?
bool is_rounding(const Arrangement::Face_handle& face, double same) {
    if (face->is_unbounded()) return false;
    Box2 box;
    const Arrangement::Ccb_halfedge_circulator first = face->outer_ccb();
    Arrangement::Ccb_halfedge_circulator edge = first;
    do box.extend(place_of(edge->source()->point()));
    while (++edge != first && box.diagonal() <= same);
    return box.diagonal() <= same;
}

/// Steps from the face on the other side of an edge to this one: the boundary has the material on its left.
int step_into(const Arrangement::Halfedge_const_handle& edge) {
    const bool runs_right = edge->direction() == CGAL::ARR_LEFT_TO_RIGHT;
    return edge->curve().is_directed_right() == runs_right ? 1 : -1;
}

/// Gives every face its winding number, from the unbounded one on; returns a corner of a face where it is neither 0 nor 1.
std::optional<Vec2> wrong_winding(Arrangement& arrangement, double same) {
    for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) face->set_data(unknown_winding);
    std::vector<Arrangement::Face_handle> open{arrangement.unbounded_face()};
    open.back()->set_data(0);
    std::optional<Vec2> wrong;
    const auto cross = [&](Arrangement::Ccb_halfedge_circulator edge) {
        const Arrangement::Ccb_halfedge_circulator first = edge;
        do {
            const Arrangement::Face_handle next = edge->twin()->face();
            if (next->data() != unknown_winding) continue;
            next->set_data(edge->face()->data() + step_into(edge->twin()));
            if (next->data() != 0 && next->data() != 1 && !is_rounding(next, same)) wrong = place_of(edge->source()->point());
            open.push_back(next);
        } while (!wrong && ++edge != first);
    };
    while (!open.empty() && !wrong) {
        const Arrangement::Face_handle face = open.back();
        open.pop_back();
        for (auto outer = face->outer_ccbs_begin(); outer != face->outer_ccbs_end(); ++outer) cross(*outer);
        for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner) cross(*inner);
    }
    return wrong;
}

}  // namespace

std::optional<OutlineFault> exact_fault(const Part& part) {
    const std::vector<PlaneCurve> outline = outline_of(part);
    Arrangement arrangement;
    CGAL::insert(arrangement, outline.begin(), outline.end());
    const Cuts cuts = cuts_of(arrangement, part);
    // Each cut makes two edges more, an end on another edge one, coincidence none: their number says that there is nothing
    // else.
    if (arrangement.number_of_edges() != outline.size() + 2 * cuts.n_rounding)
        return OutlineFault{"the outline crosses or touches itself",
                            "look for edges there that cross, overlap or end on another",
                            cuts.wrong.value_or(point(part.edges.front().curve, 0))};
    if (const std::optional<Vec2> wrong = wrong_winding(arrangement, merge_length(part)))
        return OutlineFault{"the outline has one loop too many around another, or one that runs the wrong way round",
                            "look for outlines that are drawn twice or lie in each other", *wrong};
    return std::nullopt;
}

}  // namespace abut::geometry
