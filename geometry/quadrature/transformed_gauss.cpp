// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/transformed_gauss.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/brep/monotone.hpp"
#include "geometry/cells/cell_strands.hpp"
#include "geometry/cells/grid_walk.hpp"
#include "geometry/curves/gauss.hpp"
#include "geometry/curves/numbers.hpp"
#include "geometry/quadrature/gauss_portions.hpp"

namespace abut::geometry {

namespace {

/// Points are laid along `outer` (0: x, 1: y) first, along the other axis then. A wall is a contour seen from there.
struct Wall {
    MonotonePiece piece;
    const Curve* curve;
    double low, high;  ///< along the outer axis
    bool opens;        ///< material on the side of larger inner coordinates?
    int n;             ///< Gauss points along it
};

/// Portion of an element between two walls (or sides of the cell, -1).
struct Patch {
    double low, high;
    int from, to;
};

/// One element seen along one axis.
struct View {
    int outer;
    Box2 cell;
    std::vector<Wall> walls;
    std::vector<Patch> patches;

    double inner_at(int wall, double v, double side) const {
        if (wall < 0) return side;
        const MonotonePiece& piece = walls[static_cast<std::size_t>(wall)].piece;
        return outer == 1 ? x_at(piece, v) : y_at(piece, v);
    }
    double from(const Patch& p, double v) const { return inner_at(p.from, v, cell.min[1 - outer]); }
    double to(const Patch& p, double v) const { return inner_at(p.to, v, cell.max[1 - outer]); }
};

MonotonePiece piece_of(const CellContours& cell, std::size_t k) {
    const ContourPiece& c = cell[k];
    return monotone_piece(c.edge, cell.curve(k), c.t0, c.t1, cell.begin[k], cell.end[k]);
}

/// Gauss points along a contour of a given degree of the integrand.
int points_along(const CellContours& cell, std::size_t k, int degree) {
    std::vector<GaussPortion> portions;
    append_area_portions(portions, cell.curve(k), cell[k].t0, cell[k].t1, degree, cell.box.size());
    int n = 0;
    for (const GaussPortion& portion : portions) n += portion.n;
    return std::min(n, most_gauss_points);
}

std::vector<Wall> walls_of(const CellContours& cell, const std::vector<std::size_t>& contours, int outer, int degree) {
    std::vector<Wall> walls;
    for (std::size_t k : contours) {
        const double a = cell.begin[k][outer], b = cell.end[k][outer];
        if (a == b) continue;
        // the material is on the left: of what runs down, towards larger x; of what runs right, towards larger y
        const bool opens = outer == 1 ? b < a : a < b;
        walls.push_back(
            {piece_of(cell, k), &cell.curve(k), std::min(a, b), std::max(a, b), opens, points_along(cell, k, degree)});
    }
    return walls;
}

/// Of all contours, those across the axis too.
std::vector<double> ends_of(const CellContours& cell, const std::vector<std::size_t>& contours, int outer) {
    std::vector<double> ends;
    for (std::size_t k : contours) ends.insert(ends.end(), {cell.begin[k][outer], cell.end[k][outer]});
    return ends;
}

/// Coordinates that bound slabs, ascending, none thinner than sliver_fraction of the cell. Contours that meet within that end
/// at one of them.
std::vector<double> slab_bounds(const std::vector<double>& ends, double least_height) {
    std::vector<double> bounds, sorted = ends;
    std::sort(sorted.begin(), sorted.end());
    for (double v : sorted)
        if (bounds.empty() || v - bounds.back() > least_height) bounds.push_back(v);
    return bounds;
}

/// The walls that cross a slab, by their inner coordinates in its middle.
std::vector<int> walls_across(const View& view, double low, double high) {
    const double middle = 0.5 * (low + high);
    std::vector<std::pair<double, int>> found;
    for (std::size_t w = 0; w < view.walls.size(); ++w)
        if (view.walls[w].low < middle && view.walls[w].high > middle)
            found.emplace_back(view.inner_at(static_cast<int>(w), middle, 0), static_cast<int>(w));
    std::sort(found.begin(), found.end());
    std::vector<int> walls;
    for (const auto& [at, wall] : found) walls.push_back(wall);
    return walls;
}

/// is_full: is a slab without walls all material?
template <class IsFull>
void fill_patches(View& view, const std::vector<double>& bounds, IsFull is_full) {
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        const double low = bounds[i], high = bounds[i + 1];
        const std::vector<int> walls = walls_across(view, low, high);
        if (walls.empty()) {
            if (is_full(0.5 * (low + high))) view.patches.push_back({low, high, -1, -1});
            continue;
        }
        const auto opens = [&](std::size_t w) { return view.walls[static_cast<std::size_t>(walls[w])].opens; };
        if (!opens(0)) view.patches.push_back({low, high, -1, walls[0]});
        for (std::size_t w = 0; w < walls.size(); ++w) {
            if (!opens(w)) continue;
            const bool last = w + 1 == walls.size();
            if (last || !opens(w + 1)) view.patches.push_back({low, high, walls[w], last ? -1 : walls[w + 1]});
        }
    }
}

/// Along y, the cell's right side says what slabs without walls are.
View view_along_y(const CellContours& cell, const std::vector<std::size_t>& contours, const std::vector<std::size_t>& sides,
                  int degree) {
    View view{1, cell.box, walls_of(cell, contours, 1, degree), {}};
    std::vector<double> ends = ends_of(cell, contours, 1);
    for (std::size_t k : sides) ends.insert(ends.end(), {cell[k].t0, cell[k].t1});
    fill_patches(view, slab_bounds(ends, sliver_fraction * cell.box.size().y()), [&](double y) {
        return std::any_of(sides.begin(), sides.end(), [&](std::size_t k) { return cell[k].t0 < y && y < cell[k].t1; });
    });
    return view;
}

/// Along x, what has been found along y says it: a strip without walls is all material where the tallest slab has some.
View view_along_x(const CellContours& cell, const std::vector<std::size_t>& contours, const View& along_y, int degree) {
    View view{0, cell.box, walls_of(cell, contours, 0, degree), {}};
    const auto taller = [](const Patch& a, const Patch& b) { return a.high - a.low < b.high - b.low; };
    const auto tallest = std::max_element(along_y.patches.begin(), along_y.patches.end(), taller);
    if (tallest == along_y.patches.end()) return view;
    const double y = 0.5 * (tallest->low + tallest->high);
    std::vector<double> ends = ends_of(cell, contours, 0);
    ends.insert(ends.end(), {cell.box.min.x(), cell.box.max.x()});
    fill_patches(view, slab_bounds(ends, sliver_fraction * cell.box.size().x()), [&](double x) {
        return std::any_of(along_y.patches.begin(), along_y.patches.end(), [&](const Patch& p) {
            return p.low < y && y < p.high && along_y.from(p, y) < x && x < along_y.to(p, y);
        });
    });
    return view;
}

// ---- points ----

/// Height above v (towards the lower end of a patch; sign -1: the upper one) at which the wall's inner coordinate would be as
/// the root of the distance from there: i' / 2 i'' with the derivatives by the outer coordinate. Infinite on lines, and where
/// the root is on the other side.
double distance_of_root(const View& view, int w, double v, double sign) {
    if (w < 0) return infinity;
    const Wall& wall = view.walls[static_cast<std::size_t>(w)];
    if (!wall.piece.is_arc && !wall.piece.is_general) return infinity;
    Vec2 at;
    at[view.outer] = v;
    at[1 - view.outer] = view.inner_at(w, v, 0);
    const double t = parameter_at(wall.piece, at, *wall.curve);
    const Vec2 d = derivative(*wall.curve, t), dd = second_derivative(*wall.curve, t);
    const double o = d[view.outer], i = d[1 - view.outer], bend = dd[1 - view.outer] * o - i * dd[view.outer];
    const double distance = -sign * i * o * o / (2 * bend);
    return distance >= 0 ? distance : infinity;  // not for 0 / 0, a standstill or a line
}

/// Gauss points over part of a patch: in the parameter of a curve; or evenly, or in the root of the distance from beyond one of
/// the patch's ends.
struct Span {
    double low, high;        ///< along the outer axis, or parameters of the wall
    double root = infinity;  ///< distance beyond the end
    bool beyond_high = false;
    int wall = -1;  ///< whose parameter it is
};

bool is_curved(const View& view, int wall) {
    if (wall < 0) return false;
    const MonotonePiece& piece = view.walls[static_cast<std::size_t>(wall)].piece;
    return piece.is_arc || piece.is_general;
}

/// Between a curve and something straight, the curve's own parameter: however steep it is, nothing is then less smooth than it.
Span span_along(const View& view, const Patch& p, int w) {
    const Wall& wall = view.walls[static_cast<std::size_t>(w)];
    const double a = line_meeting(wall.piece, view.outer, p.low, *wall.curve).t;
    const double b = line_meeting(wall.piece, view.outer, p.high, *wall.curve).t;
    return {std::min(a, b), std::max(a, b), infinity, false, w};
}

/// One end of a patch: the nearer root beyond it, and where the other wall's is farther, up to where the two look different.
struct End {
    double root = infinity, apart = 0;
};

End end_of(const View& view, const Patch& p, double v, double sign) {
    double near = distance_of_root(view, p.from, v, sign), far = distance_of_root(view, p.to, v, sign);
    if (far < near) std::swap(near, far);
    const double height = p.high - p.low;
    if (!(near < height)) return {};  // from farther away it does no harm
    const double apart = 4 * (far - near);
    return {near, apart < 0.5 * height ? apart : 0};
}

/// Between two curves, the coordinate. Two ends with roots share the patch. Between walls whose roots are a little apart (the
/// two sides of a thin ring), a span as long as that is of its own.
std::vector<Span> spans_of(const View& view, const Patch& p) {
    const bool from_curve = is_curved(view, p.from), to_curve = is_curved(view, p.to);
    if (from_curve != to_curve) return {span_along(view, p, from_curve ? p.from : p.to)};
    const End low = end_of(view, p, p.low, 1), high = end_of(view, p, p.high, -1);
    if (low.root == infinity && high.root == infinity) return {{p.low, p.high}};
    const double middle = high.root == infinity ? p.high : low.root == infinity ? p.low : 0.5 * (p.low + p.high);
    std::vector<Span> spans;
    const auto add = [&](double from, double to, double root, bool beyond_high) {
        if (to > from) spans.push_back({from, to, root, beyond_high});
    };
    add(p.low, p.low + low.apart, low.root, false);
    add(p.low + low.apart, middle, low.root + low.apart, false);
    add(middle, p.high - high.apart, high.root + high.apart, true);
    add(p.high - high.apart, p.high, high.root, true);
    return spans;
}

/// A row of points: where it is along the outer axis, from where to where it goes, and its weight.
struct Row {
    double v, from, to, weight;
};

Row row_along(const View& view, const Patch& p, const Span& span, double s, double weight) {
    const Curve& curve = *view.walls[static_cast<std::size_t>(span.wall)].curve;
    const double t = span.low + s * (span.high - span.low);
    const Vec2 x = point(curve, t);
    Row row{x[view.outer], 0, 0, weight * (span.high - span.low) * std::abs(derivative(curve, t)[view.outer])};
    row.from = span.wall == p.from ? x[1 - view.outer] : view.from(p, row.v);
    row.to = span.wall == p.to ? x[1 - view.outer] : view.to(p, row.v);
    return row;
}

/// With s in [0, 1] the distance from the root is (a + (b - a) s)^2.
Row row_at(const View& view, const Patch& p, const Span& span, double s, double weight) {
    if (span.wall >= 0) return row_along(view, p, span, s, weight);
    const double height = span.high - span.low;
    double v = span.low + s * height;
    weight *= height;
    if (span.root < infinity) {
        const double a = std::sqrt(span.root), b = std::sqrt(span.root + height), r = a + (b - a) * s;
        const double distance = (b - a) * s * (r + a);  // from the end: r^2 - a^2
        v = span.beyond_high ? span.high - distance : span.low + distance;
        weight *= 2 * r * (b - a) / height;
    }
    return {v, view.from(p, v), view.to(p, v), weight};
}

bool is_constant(const View& view, int wall) {
    if (wall < 0) return true;
    const MonotonePiece& piece = view.walls[static_cast<std::size_t>(wall)].piece;
    return piece.from[1 - view.outer] == piece.to[1 - view.outer];
}

/// Between sides a product rule; between walls what the steeper one asks for, and half as much again for the root's square.
int n_outer(const View& view, const Patch& p, const Span& span, int degree, int extra) {
    int n = degree + 1;
    for (int wall : {p.from, p.to})
        if (!is_constant(view, wall)) n = std::max(n, view.walls[static_cast<std::size_t>(wall)].n);
    if (span.root < infinity) n += degree + 1;
    return std::min(n + extra, most_gauss_points);
}

int n_inner(int degree, int extra) {
    return std::min(degree + 1 + extra, most_gauss_points);
}

std::size_t count_points(const View& view, int degree, int extra) {
    std::size_t n = 0;
    for (const Patch& p : view.patches)
        for (const Span& span : spans_of(view, p))
            n += static_cast<std::size_t>(n_outer(view, p, span, degree, extra) * n_inner(degree, extra));
    return n;
}

void add_row(CellRule& rule, int outer, const Row& row, const GaussRule& inner) {
    const double width = row.to - row.from;
    if (!(width > 0 && row.weight > 0)) return;
    for (std::size_t j = 0; j < inner.points.size(); ++j) {
        Vec2 x;
        x[outer] = row.v;
        x[1 - outer] = row.from + inner.points[j] * width;
        rule.points.push_back(x);
        rule.weights.push_back(row.weight * inner.weights[j] * width);
    }
}

void add_points(CellRule& rule, const View& view, int degree, int extra) {
    const GaussRule& inner = gauss_rule(n_inner(degree, extra));
    for (const Patch& p : view.patches)
        for (const Span& span : spans_of(view, p)) {
            const GaussRule& outer = gauss_rule(n_outer(view, p, span, degree, extra));
            for (std::size_t i = 0; i < outer.points.size(); ++i)
                add_row(rule, view.outer, row_at(view, p, span, outer.points[i], outer.weights[i]), inner);
        }
}

/// Contours of one element: of edges, and of the right side.
void add_element(CellRule& rule, const CellContours& cell, const std::vector<std::size_t>& contours,
                 const std::vector<std::size_t>& sides, int degree, int extra) {
    const View along_y = view_along_y(cell, contours, sides, degree);
    const View along_x = view_along_x(cell, contours, along_y, degree);
    const bool by_y = count_points(along_y, degree, extra) <= count_points(along_x, degree, extra);
    add_points(rule, by_y ? along_y : along_x, degree, extra);
}

}  // namespace

std::vector<CellRule> transformed_rules(const Part& part, const CutCells& cells, const Elements& elements, int degree,
                                        int extra) {
    std::vector<CellRule> rules;
    CellContours cell;
    std::vector<std::size_t> contours, sides;
    const auto n_cells = cells.cell_class.size();
    auto extra_element = static_cast<int>(n_cells);
    const auto end_element = static_cast<int>(elements.fraction.size());
    for (std::size_t c = 0; c < n_cells; ++c) {
        if (cells.cell_class[c] != CellClass::boundary) continue;
        set_cell(cell, part, cells, static_cast<int>(c));
        const auto first = static_cast<std::size_t>(cells.first_contour[c]);
        for (int element = static_cast<int>(c); element >= 0;) {
            contours.clear();
            sides.clear();
            for (std::size_t k = 0; k < cell.contours.size(); ++k)
                if (elements.of_contour[first + k] == element) (k < cell.n_edges ? contours : sides).push_back(k);
            rules.push_back({element, {}, {}});
            add_element(rules.back(), cell, contours, sides, degree, extra);
            const bool more = extra_element < end_element && elements.cell_of(extra_element) == static_cast<int>(c);
            element = more ? extra_element++ : -1;
        }
    }
    return rules;
}

}  // namespace abut::geometry
