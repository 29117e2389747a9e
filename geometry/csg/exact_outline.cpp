// SPDX-License-Identifier: GPL-3.0-or-later
// 1. The outline becomes lines and arcs of at most half a turn between doubles (`pieces_of`).
// 2. Pairs whose boxes come together: interval arithmetic proves most of them to have nothing but corners in common
//    (clear_pieces); the rest is intersected exactly.
// 3. Then the winding numbers beside a loop are the same all along it, but for corners that others share. One point of each
//    stretch between such corners is asked for them, along a ray, exactly.
// 4. Where this does not prove the outline right, the sweep of CGAL makes an arrangement of all of it, says whether it is, and
//    what is wrong.
// What pieces have in common, and winding numbers, serve pairs of outlines as well (common_boundary.cpp).
#include "geometry/csg/exact_outline.hpp"

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/MP_Float.h>

#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/variant.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <type_traits>
#include <variant>
#include <vector>

#include "geometry/brep/oriented_tree.hpp"
#include "geometry/csg/clear_pieces.hpp"
#include "geometry/csg/exact_count.hpp"
#include "geometry/curves/arc_spline.hpp"
#include "src/base/index.hpp"

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

/// Appends the line or arc in pieces along which x is monotone.
void append(const OutlinePiece& piece, std::vector<PlaneCurve>& outline) {
    const Kernel::Point_2 begin = corner_at(piece.from), end = corner_at(piece.to);
    if (piece.turn == 0) {
        outline.emplace_back(begin, end);
        return;
    }
    const auto take = [&](const auto& made) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(made)>, PlaneTraits::Point_2>) outline.push_back(piece_in(made));
    };
    PlaneTraits().make_x_monotone_2_object()(PlaneTraits::Curve_2(begin, corner_at(piece.middle), end),
                                             boost::make_function_output_iterator(take));
}

/// Arcs as short as smoother outlines need decide nothing here: with kinks like these there are half as many.
constexpr double outline_kink = 1e-2;

/// Lines and arcs of at most `most_turn` that follow the curve.
std::vector<ArcPiece> simple_pieces(const Curve& curve, double tolerance, double most_turn) {
    if (const auto* arc = std::get_if<Arc>(&curve)) {
        const double n = std::ceil(std::abs(arc->sweep) / most_turn - 1e-9);
        std::vector<ArcPiece> pieces;
        for (double k = 0; k < n; ++k) pieces.push_back({trimmed(curve, k / n, (k + 1) / n), k / n, (k + 1) / n});
        return pieces;
    }
    return arc_spline(curve, {tolerance, outline_kink});
}

using Pieces = std::vector<OutlinePiece>;

/// The pieces of each loop, head to tail. Curves whose boxes do not meet `near` are their chords, and a loop of one such curve
/// is none: how often the loops wind around what is near is the same.
std::vector<Pieces> pieces_of(const Part& part, double tolerance, double most_turn, const std::optional<Box2>& near = {}) {
    std::vector<Pieces> loops;
    for (const Loop& loop : part.loops) {
        Pieces& pieces = loops.emplace_back();
        for (const int e : loop.edges) {
            const Curve& curve = curve_of(part, e);
            const bool is_far = near && !bounding_box(curve).overlaps(*near, tolerance);
            if (is_far && loop.edges.size() == 1) continue;
            const Curve chord = Segment{point(curve, 0), point(curve, 1)};
            for (const ArcPiece& made : simple_pieces(is_far ? chord : curve, tolerance, most_turn)) {
                pieces.push_back({point(made.curve, 0), point(made.curve, 0.5), {0, 0}, 0, e, made.t0, made.t1});
                if (std::holds_alternative<Segment>(made.curve)) pieces.back().middle = pieces.back().from;
            }
        }
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            OutlinePiece& piece = pieces[i];
            piece.to = pieces[(i + 1) % pieces.size()].from;
            piece.turn = CGAL::orientation(corner_at(piece.from), corner_at(piece.middle), corner_at(piece.to));
        }
    }
    return loops;
}

std::vector<Pieces> pieces_of(const Part& part) {
    return pieces_of(part, arc_spline_fraction * bounding_box(part).diagonal(), std::numbers::pi);
}

/// Sums and products of doubles, without the cost of fractions.
using Exact = CGAL::MP_Float;
struct ExactVector {
    Exact x, y;
};
ExactVector exact_vector(const Vec2& from, const Vec2& to) {
    return {Exact(to.x()) - Exact(from.x()), Exact(to.y()) - Exact(from.y())};
}
ExactVector operator*(const Exact& s, const ExactVector& v) {
    return {s * v.x, s * v.y};
}
ExactVector operator+(const ExactVector& a, const ExactVector& b) {
    return {a.x + b.x, a.y + b.y};
}
Exact cross(const ExactVector& a, const ExactVector& b) {
    return a.x * b.y - a.y * b.x;
}
Exact squared(const ExactVector& v) {
    return v.x * v.x + v.y * v.y;
}

/// The centre lies at the arc's begin plus to_center / divisor.
struct ExactCircle {
    ExactVector to_center;
    Exact divisor;
};
ExactCircle exact_circle(const OutlinePiece& arc) {
    const ExactVector u = exact_vector(arc.from, arc.middle), v = exact_vector(arc.from, arc.to);
    const Exact uu = squared(u), vv = squared(v);
    return {{uu * v.y - vv * u.y, vv * u.x - uu * v.x}, Exact(2) * cross(u, v)};
}

bool is_apart_from_line(const OutlinePiece& arc, const OutlinePiece& line) {
    const ExactCircle circle = exact_circle(arc);
    const ExactVector along = exact_vector(line.from, line.to);
    const Exact distance = cross(along, circle.divisor * exact_vector(line.from, arc.from) + circle.to_center);
    return distance * distance > squared(circle.to_center) * squared(along);
}

/// Are the pieces the same, or each other's reverse? As most faces of parts that fit each other are: exact intersection has
/// nowhere to stop early there.
bool are_one(const OutlinePiece& a, const OutlinePiece& b) {
    if (a.turn != 0 && a.middle != b.middle) return false;
    return (a.from == b.from && a.to == b.to && a.turn == b.turn) || (a.from == b.to && a.to == b.from && a.turn == -b.turn);
}

/// Have the lines or circles that two pieces lie on no point in common? Some microseconds: of pieces that come within rounding
/// of each other most are apart.
bool carriers_are_apart(const OutlinePiece& a, const OutlinePiece& b) {
    if (a.turn == 0 && b.turn == 0) return false;
    if (b.turn == 0) return is_apart_from_line(a, b);
    if (a.turn == 0) return is_apart_from_line(b, a);
    const ExactCircle first = exact_circle(a), second = exact_circle(b);
    // Squares of the radii and of the distance, times those of both divisors.
    const Exact p = second.divisor * second.divisor * squared(first.to_center),
                q = first.divisor * first.divisor * squared(second.to_center),
                d = squared(first.divisor * second.divisor * exact_vector(a.from, b.from) + first.divisor * second.to_center +
                            (-second.divisor) * first.to_center);
    const Exact both = p + q - d;
    return both * both > Exact(4) * p * q;
}

/// Hands to `add` what two curves have in common: a stretch, or a crossing with its multiplicity. CGAL 5 has either in boost's
/// variant, CGAL 6 as it is.
template <class Common, class Add>
void add_common(const Common& common, const Add& add) {
    if constexpr (std::is_same_v<Common, PlaneCurve> || std::is_same_v<Common, std::pair<PlaneTraits::Point_2, unsigned>>)
        add(common);
    else
        boost::apply_visitor(add, common);
}

/// What the curves of two pieces have in common, which share these corners.
std::vector<CommonOfPieces> common_of_curves(const std::vector<PlaneCurve>& first, const std::vector<PlaneCurve>& second,
                                             const std::vector<Vec2>& shared) {
    const auto is_corner = [&](const PlaneTraits::Point_2& p) {
        return std::any_of(shared.begin(), shared.end(), [&](const Vec2& corner) {
            return p.equals(PlaneTraits::Point_2(Kernel::FT(corner.x()), Kernel::FT(corner.y())));
        });
    };
    std::vector<CommonOfPieces> found;
    const auto add = [&](const auto& common) {
        if constexpr (std::is_same_v<std::decay_t<decltype(common)>, PlaneCurve>)
            found.push_back({place_of(common.source()), place_of(common.target()), true, false});
        else
            found.push_back({place_of(common.first), place_of(common.first), false, is_corner(common.first)});
    };
    const auto take = boost::make_function_output_iterator([&](const auto& common) { add_common(common, add); });
    for (const PlaneCurve& one : first)
        for (const PlaneCurve& other : second) one.intersect(other, take);
    return found;
}

std::vector<CommonOfPieces> common_of(const OutlinePiece& a, const OutlinePiece& b) {
    if (carriers_are_apart(a, b)) return {};
    std::vector<PlaneCurve> first, second;
    append(a, first);
    append(b, second);
    return common_of_curves(first, second, shared_corners(a, b));
}

/// Have two pieces nothing in common but the corners that they share, and what is rounding there?
bool meet_at_corners_only(const OutlinePiece& a, const OutlinePiece& b, double same) {
    const std::vector<Vec2> shared = shared_corners(a, b);
    const auto is_rounding = [&](const CommonOfPieces& common) {
        return std::any_of(shared.begin(), shared.end(), [&](const Vec2& corner) {
            const bool begins = (corner == a.from && a.begins_edge()) || (corner == b.from && b.begins_edge());
            return begins && (common.begin - corner).norm() <= same;
        });
    };
    const std::vector<CommonOfPieces> all = common_of(a, b);
    return std::all_of(all.begin(), all.end(), [&](const CommonOfPieces& common) {
        return !common.is_stretch && (common.is_shared_corner || is_rounding(common));
    });
}

/// Where more pairs of boxes come together for each piece (rings in rings), the sweep is the cheaper way.
constexpr std::size_t most_pairs_of_piece = 100;

bool all_meet_at_corners_only(const Outline& outline, double same) {
    const std::vector<HulledPiece>& pieces = outline.pieces;
    std::vector<OrientedTree::Item> items;
    items.reserve(pieces.size());
    for (const HulledPiece& piece : pieces) items.push_back({piece.box, oriented_box(piece.hull)});
    const OrientedTree tree(items);
    std::size_t n_pairs = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const int found : tree.near_after(i, 0)) {
            const std::size_t j = at(found);
            if (++n_pairs > most_pairs_of_piece * pieces.size()) return false;
            if (!clearly_meet_at_corners_only(pieces[i], pieces[j]) &&
                !meet_at_corners_only(pieces[i].piece, pieces[j].piece, same))
                return false;
        }
    }
    return true;
}

/// A point exactly on a piece, to be moved as windings_around says.
struct Place {
    Kernel::Point_2 at;
    Box2 box;
};

/// Where the line from the piece's far end towards the place meets its line or circle again.
Place exact_place(const PlaceOnPiece& place) {
    const OutlinePiece& piece = place.piece;
    const Kernel::Point_2 from = corner_at(piece.from), to = corner_at(piece.to);
    Kernel::Point_2 p = from + Kernel::FT(place.share) * (to - from);
    if (piece.turn != 0 && place.share == 0.5) {
        p = corner_at(piece.middle);
    } else if (piece.turn != 0) {
        const Kernel::Point_2& far_end = place.share < 0.5 ? to : from;
        const Kernel::Vector_2 along = corner_at(point_above(piece, place.share)) - far_end,
                               to_center = CGAL::circumcenter(from, corner_at(piece.middle), to) - far_end;
        p = far_end + Kernel::FT(2 * (to_center * along) / (along * along)) * along;
    }
    const auto [x0, x1] = CGAL::to_interval(p.x());
    const auto [y0, y1] = CGAL::to_interval(p.y());
    return {p, {{x0, y0}, {x1, y1}}};
}

bool is_right_of(double x, const Place& place) {
    if (x > place.box.max.x() || x < place.box.min.x()) return x > place.box.max.x();
    return place.at.x() < x;
}

/// Is the place, moved, on the left of the chord?
bool is_left_of_chord(const OutlinePiece& piece, const Place& place) {
    const CGAL::Orientation side = CGAL::orientation(corner_at(piece.from), corner_at(piece.to), place.at);
    if (side != CGAL::COLLINEAR) return side == CGAL::LEFT_TURN;
    return piece.from.x() < piece.to.x() || (piece.from.x() == piece.to.x() && piece.from.y() > piece.to.y());
}

/// Is the place, moved, within the arc's circle?
bool is_in_circle(const OutlinePiece& arc, const Place& place) {
    const Kernel::Point_2 a = corner_at(arc.from), m = corner_at(arc.middle), b = corner_at(arc.to);
    const CGAL::Bounded_side side = CGAL::side_of_bounded_circle(a, m, b, place.at);
    if (side != CGAL::ON_BOUNDARY) return side == CGAL::ON_BOUNDED_SIDE;
    const Kernel::Point_2 center = CGAL::circumcenter(a, m, b);
    const CGAL::Comparison_result up = CGAL::compare_y(place.at, center);
    return up == CGAL::SMALLER || (up == CGAL::EQUAL && CGAL::compare_x(place.at, center) == CGAL::SMALLER);
}

/// By how much a piece whose box the place is in raises its winding number, moved: by the chord if that is above, and by what
/// is between arc and chord if the place is there.
int winding_by(const OutlinePiece& piece, const Place& place) {
    const int runs_left = is_right_of(piece.from.x(), place) - is_right_of(piece.to.x(), place);
    const bool is_left = is_left_of_chord(piece, place);
    const int by_chord = is_left == (runs_left > 0) ? runs_left : 0;
    return piece.turn != 0 && is_left == (piece.turn < 0) && is_in_circle(piece, place) ? by_chord + piece.turn : by_chord;
}

/// Numbers by rank, which change, and their sums (a binary indexed tree).
class Sums {
public:
    explicit Sums(std::size_t n) : sums_(n + 1) {}
    void add(std::size_t rank, int number) {
        for (std::size_t i = rank + 1; i < sums_.size(); i += i & (~i + 1)) sums_[i] += number;
    }
    /// Of the first `n`.
    int of_first(std::size_t n) const {
        int sum = 0;
        for (; n > 0; n -= n & (~n + 1)) sum += sums_[n];
        return sum;
    }

private:
    std::vector<int> sums_;
};

/// What the pieces whose boxes are above a place add to its winding number, for each place: 1 for each that begins right of it,
/// -1 for each that ends there. Both are taken from the top down.
std::vector<int> windings_from_above(const std::vector<HulledPiece>& pieces, const std::vector<Place>& places) {
    std::vector<double> xs;
    for (const HulledPiece& p : pieces) xs.push_back(p.piece.from.x());
    std::sort(xs.begin(), xs.end());
    const auto rank = [&](double x) {
        return static_cast<std::size_t>(std::lower_bound(xs.begin(), xs.end(), x) - xs.begin());
    };
    const auto from_the_top = [](std::size_t n, const auto& y_of) {
        std::vector<std::size_t> order(n);
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return y_of(i) > y_of(j); });
        return order;
    };
    const auto bottom = [&](std::size_t i) { return pieces[i].box.min.y(); };
    const auto top = [&](std::size_t i) { return places[i].box.max.y(); };
    const std::vector<std::size_t> order = from_the_top(pieces.size(), bottom);
    Sums begun(xs.size());
    std::vector<int> windings(places.size());
    auto next = order.begin();
    for (const std::size_t k : from_the_top(places.size(), top)) {
        for (; next != order.end() && bottom(*next) > top(k); ++next) {
            begun.add(rank(pieces[*next].piece.from.x()), 1);
            begun.add(rank(pieces[*next].piece.to.x()), -1);
        }
        const auto right = std::partition_point(xs.begin(), xs.end(), [&](double x) { return !is_right_of(x, places[k]); });
        windings[k] = -begun.of_first(static_cast<std::size_t>(right - xs.begin()));  // as many begin as end
    }
    return windings;
}

std::vector<Place> exact_places(const std::vector<PlaceOnPiece>& asked) {
    std::vector<Place> places;
    for (const PlaceOnPiece& place : asked) places.push_back(exact_place(place));
    return places;
}

std::vector<int> windings_at(const Outline& outline, const std::vector<Place>& places) {
    std::vector<int> windings = windings_from_above(outline.pieces, places);
    for (std::size_t k = 0; k < places.size(); ++k)
        for (const int i : outline.tree.near(places[k].box, 0))
            if (outline.pieces[at(i)].box.min.y() <= places[k].box.max.y())
                windings[k] += winding_by(outline.pieces[at(i)].piece, places[k]);
    return windings;
}

/// Is a place on this piece, moved, on the left of it?
bool is_left_of(const OutlinePiece& piece, const Place& place) {
    return piece.turn == 0 ? is_left_of_chord(piece, place) : is_in_circle(piece, place) == (piece.turn > 0);
}

bool comes_before(const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

/// Corners that several pieces begin at, sorted.
std::vector<Vec2> touched_corners(const std::vector<Pieces>& loops) {
    std::vector<Vec2> corners, touched;
    for (const Pieces& loop : loops)
        for (const OutlinePiece& piece : loop) corners.push_back(piece.from);
    std::sort(corners.begin(), corners.end(), comes_before);
    for (std::size_t i = 1; i < corners.size(); ++i)
        if (corners[i] == corners[i - 1]) touched.push_back(corners[i]);
    return touched;
}

/// The longest piece of each stretch of the loops between touched corners.
Pieces longest_of_stretches(const std::vector<Pieces>& loops) {
    const std::vector<Vec2> touched = touched_corners(loops);
    const auto length_of = [](const OutlinePiece& piece) { return (piece.to - piece.from).norm(); };
    Pieces longest;
    for (const Pieces& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const bool begins = i == 0 || std::binary_search(touched.begin(), touched.end(), loop[i].from, comes_before);
            if (begins)
                longest.push_back(loop[i]);
            else if (length_of(loop[i]) > length_of(longest.back()))
                longest.back() = loop[i];
        }
    }
    return longest;
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

struct PieceMeetings::Known {
    const Outline &a, &b;
    std::map<std::size_t, std::vector<PlaneCurve>> curves_of_a, curves_of_b;
};

PieceMeetings::PieceMeetings(const Outline& a, const Outline& b) : known_(new Known{a, b, {}, {}}) {}

PieceMeetings::~PieceMeetings() = default;

std::vector<CommonOfPieces> PieceMeetings::of(std::size_t i, std::size_t j) {
    const OutlinePiece &a = known_->a.pieces[i].piece, &b = known_->b.pieces[j].piece;
    if (are_one(a, b)) return {{a.from, a.to, true, false}};
    if (carriers_are_apart(a, b)) return {};
    const auto curves = [](std::map<std::size_t, std::vector<PlaneCurve>>& known, std::size_t k,
                           const OutlinePiece& piece) -> const std::vector<PlaneCurve>& {
        const auto [found, is_new] = known.try_emplace(k);
        if (is_new) append(piece, found->second);
        return found->second;
    };
    return common_of_curves(curves(known_->curves_of_a, i, a), curves(known_->curves_of_b, j, b), shared_corners(a, b));
}

std::vector<int> windings_around(const Outline& outline, const std::vector<PlaceOnPiece>& places) {
    return windings_at(outline, exact_places(places));
}

Outline fine_outline(const Part& part, double tolerance, const Box2& near) {
    return outline_of(pieces_of(part, tolerance, 0.5 * std::numbers::pi, near));
}

bool is_surely_right(const Part& part) {
    const double same = merge_length(part);
    const std::vector<Pieces> loops = pieces_of(part);
    const Outline outline = outline_of(loops);
    if (!outline.is_sound || !all_meet_at_corners_only(outline, same)) return false;
    std::vector<PlaceOnPiece> asked;
    for (const OutlinePiece& piece : longest_of_stretches(loops)) {
        // The middle of a longer piece is beyond what is rounding at its ends.
        if ((piece.to - piece.from).norm() <= 4 * same) return false;
        asked.push_back({piece});
    }
    const std::vector<Place> places = exact_places(asked);
    const std::vector<int> windings = windings_at(outline, places);
    for (std::size_t k = 0; k < asked.size(); ++k)
        if (windings[k] != (is_left_of(asked[k].piece, places[k]) ? 1 : 0)) return false;
    return true;
}

std::optional<OutlineFault> exact_fault(const Part& part) {
    n_exact_loops() += static_cast<long>(part.loops.size());
    if (is_surely_right(part)) return std::nullopt;
    return swept_fault(part);
}

std::optional<OutlineFault> swept_fault(const Part& part) {
    std::vector<PlaneCurve> outline;
    for (const Pieces& loop : pieces_of(part))
        for (const OutlinePiece& piece : loop) append(piece, outline);
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
