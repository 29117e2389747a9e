// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/quadrature.hpp"

#include <algorithm>

#include "geometry/curves/gauss.hpp"
#include "geometry/quadrature/gauss_portions.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// Of a piece that has no cell (-1): the whole grid's.
Vec2 cell_size(const Grid& grid, int cell) {
    return (cell < 0 ? grid.box() : grid.box(cell)).size();
}

void add_row(CellRule& rule, double x0, const Vec2& end, double dy, const GaussRule& inner) {
    const double width = end.x() - x0;
    for (std::size_t k = 0; k < inner.points.size(); ++k) {
        rule.points.emplace_back(x0 + inner.points[k] * width, end.y());
        rule.weights.push_back(inner.weights[k] * width * dy);
    }
}

/// `portions`: kept over contours, so that they allocate nothing.
void add_contour(CellRule& rule, const Part& part, const Grid& grid, const ContourPiece& c, int degree,
                 std::vector<GaussPortion>& portions) {
    const Box2 box = grid.box(c.cell);
    const double x0 = box.min.x();
    const GaussRule& inner = gauss_rule(degree + 1);
    if (c.edge < 0) {
        const GaussRule& outer = gauss_rule(degree + 1);
        for (std::size_t i = 0; i < outer.points.size(); ++i)
            add_row(rule, x0, {box.max.x(), c.t0 + outer.points[i] * (c.t1 - c.t0)}, outer.weights[i] * (c.t1 - c.t0), inner);
        return;
    }
    const Curve& curve = part.edges[static_cast<std::size_t>(c.edge)].curve;
    portions.clear();
    append_area_portions(portions, curve, c.t0, c.t1, degree, box.size());
    for (const GaussPortion& portion : portions) {
        const GaussRule& outer = gauss_rule(portion.n);
        for (std::size_t i = 0; i < outer.points.size(); ++i) {
            const double t = portion.t0 + outer.points[i] * (portion.t1 - portion.t0);
            const double dy = outer.weights[i] * (portion.t1 - portion.t0) * derivative(curve, t).y();
            if (dy != 0) add_row(rule, x0, point(curve, t), dy, inner);
        }
    }
}

/// Of the boundary cells in order, in each of its elements in ascending order. element_of(contour): -1 for what does not count.
template <class ElementOf>
std::vector<CellRule> rules_by_element(const Part& part, const CutCells& cells, int degree, ElementOf element_of) {
    std::vector<CellRule> rules;
    std::vector<GaussPortion> portions;
    for (std::size_t c = 0; c < cells.cell_class.size(); ++c) {
        if (cells.cell_class[c] != CellClass::boundary) continue;
        const auto first = static_cast<std::ptrdiff_t>(rules.size());  // the cell's own; further elements are numbered beyond
        rules.push_back({static_cast<int>(c), {}, {}});
        for (auto k = static_cast<std::size_t>(cells.first_contour[c]);
             k < static_cast<std::size_t>(cells.first_contour[c + 1]); ++k) {
            const int element = element_of(k);
            if (element < 0) continue;
            auto rule = std::lower_bound(rules.begin() + first, rules.end(), element,
                                         [](const CellRule& r, int e) { return r.element < e; });
            if (rule == rules.end() || rule->element != element) rule = rules.insert(rule, {element, {}, {}});
            add_contour(*rule, part, cells.grid, cells.contours[k], degree, portions);
        }
    }
    return rules;
}

template <class ElementOf>
std::vector<BoundaryPoint> rule_along(const Part& part, const CutCells& cells, int edge, double t0, double t1, int n,
                                      ElementOf element_of) {
    std::vector<BoundaryPoint> points;
    std::vector<GaussPortion> portions;
    const auto e = static_cast<std::size_t>(edge);
    ENSURE(e < part.edges.size() && cells.first_piece.size() == part.edges.size() + 1,
           "the cells are those that cut this part");
    const Curve& curve = part.edges[e].curve;
    for (auto k = static_cast<std::size_t>(cells.first_piece[e]); k < static_cast<std::size_t>(cells.first_piece[e + 1]); ++k) {
        const BoundaryPiece& piece = cells.pieces[k];
        const double a = std::max(t0, piece.t0), b = std::min(t1, piece.t1);
        if (b <= a) continue;
        portions.clear();
        append_length_portions(portions, curve, a, b, n, cell_size(cells.grid, piece.cell));
        const int element = element_of(k);
        for (const GaussPortion& portion : portions) {
            const GaussRule& rule = gauss_rule(portion.n);
            const double width = portion.t1 - portion.t0;
            for (std::size_t i = 0; i < rule.points.size(); ++i) {
                const double t = portion.t0 + rule.points[i] * width;
                points.push_back({element, edge, t, point(curve, t), outward_normal(curve, t),
                                  rule.weights[i] * width * derivative(curve, t).norm()});
            }
        }
    }
    return points;
}

}  // namespace

std::vector<CellRule> cell_rules(const Part& part, const CutCells& cells, int degree) {
    return rules_by_element(part, cells, degree, [&](std::size_t contour) { return cells.contours[contour].cell; });
}

std::vector<CellRule> cell_rules(const Part& part, const CutCells& cells, const Elements& elements, int degree) {
    return rules_by_element(part, cells, degree, [&](std::size_t contour) { return elements.of_contour[contour]; });
}

std::vector<BoundaryPoint> boundary_rule(const Part& part, const CutCells& cells, int edge, double t0, double t1, int n) {
    return rule_along(part, cells, edge, t0, t1, n, [&](std::size_t piece) { return cells.pieces[piece].cell; });
}

std::vector<BoundaryPoint> boundary_rule(const Part& part, const CutCells& cells, const Elements& elements, int edge, double t0,
                                         double t1, int n) {
    return rule_along(part, cells, edge, t0, t1, n, [&](std::size_t piece) { return elements.of_piece[piece]; });
}

}  // namespace abut::geometry
