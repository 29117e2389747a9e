// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/elements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/cells/cell_trace.hpp"
#include "geometry/cells/element_links.hpp"
#include "geometry/cells/grid_walk.hpp"

namespace abut::geometry {

namespace {

/// The element of a cell's component; -1 stays.
int element_of(const Elements& elements, int cell, int component, std::size_t first_extra) {
    if (component <= 0) return component < 0 ? -1 : cell;
    const std::size_t n_cells = elements.fraction.size() - elements.cell_of_extra.size();
    return static_cast<int>(n_cells + first_extra) + component - 1;
}

/// Takes over the components of a cell. Extra elements are appended.
void add_cell(Elements& elements, ElementSides& sides, const CutCells& cells, int cell, const CellTrace& trace) {
    const std::size_t first_extra = elements.cell_of_extra.size();
    if (trace.n_components() > 1) elements.fraction[static_cast<std::size_t>(cell)] = trace.fraction[0];
    for (int k = 1; k < trace.n_components(); ++k) {
        elements.cell_of_extra.push_back(cell);
        elements.fraction.push_back(trace.fraction[static_cast<std::size_t>(k)]);
    }
    const auto element = [&](int component) { return element_of(elements, cell, component, first_extra); };
    const auto contour = static_cast<std::size_t>(cells.first_contour[static_cast<std::size_t>(cell)]);
    for (std::size_t k = 0; k < trace.of_contour.size(); ++k) elements.of_contour[contour + k] = element(trace.of_contour[k]);
    for (const SideStretch& s : trace.stretches)
        if (s.component >= 0) sides.stretches.push_back({element(s.component), s.side, s.from, s.to});
    sides.boundary_cells.push_back(cell);
    sides.first.push_back(static_cast<int>(sides.stretches.size()));
    elements.unclear += trace.unclear;
}

struct ElementRange {
    int first_extra, end_extra;
};
ElementRange extras_of(const Elements& elements, int cell) {
    const auto n_cells = static_cast<int>(elements.fraction.size() - elements.cell_of_extra.size());
    const auto& all = elements.cell_of_extra;
    const auto [from, to] = std::equal_range(all.begin(), all.end(), cell);
    return {n_cells + static_cast<int>(from - all.begin()), n_cells + static_cast<int>(to - all.begin())};
}

bool is_split(const Elements& elements, int cell) {
    if (elements.cell_of_extra.empty()) return false;
    const ElementRange extras = extras_of(elements, cell);
    return extras.first_extra < extras.end_extra;
}

Vec2 clamped(const Vec2& p, const Box2& box) {
    return p.cwiseMax(box.min).cwiseMin(box.max);
}

/// A contour as a point sees it.
struct Nearest {
    int element;
    double distance = std::numeric_limits<double>::infinity();
    bool is_left = false;  ///< is the point on the material's side?
};

/// At a tip that two contours share, the one on whose material's side the point is.
bool is_nearer(const Nearest& a, const Nearest& b, double rounding) {
    if (std::abs(a.distance - b.distance) <= rounding) return a.is_left && !b.is_left;
    return a.distance < b.distance;
}

/// The straight way from a point of the cell to the nearest contour in it meets no other: the point is in that contour's
/// component, or outside and next to it.
int element_in_cell(const Part& part, const CutCells& cells, const Elements& elements, int cell, const Vec2& p) {
    if (!is_split(elements, cell)) return cell;
    const Vec2 q = clamped(p, cells.grid.box(cell));
    Nearest nearest{cell};
    const auto c = static_cast<std::size_t>(cell);
    for (auto k = static_cast<std::size_t>(cells.first_contour[c]); k < static_cast<std::size_t>(cells.first_contour[c + 1]);
         ++k) {
        const ContourPiece& piece = cells.contours[k];
        if (piece.edge < 0 || elements.of_contour[k] < 0) continue;
        const Curve curve = trimmed(part.edges[static_cast<std::size_t>(piece.edge)].curve, piece.t0, piece.t1);
        const double t = closest_parameter(curve, q);
        const Vec2 d = q - point(curve, t);
        const Nearest seen{elements.of_contour[k], d.norm(), d.dot(outward_normal(curve, t)) < 0};
        if (is_nearer(seen, nearest, crossing_fraction * cells.merge)) nearest = seen;
    }
    return nearest.element;
}

/// Looked for in boxes around the point that grow until no nearer cell can follow. -1 where no cell holds material.
int nearest_cell_with_material(const CutCells& cells, const Elements& elements, const Vec2& p) {
    const Grid& grid = cells.grid;
    const int own = grid.cell_at(p);
    const Box2 all = grid.box();
    const double most = std::max((p - all.min).cwiseAbs().maxCoeff(), (p - all.max).cwiseAbs().maxCoeff());
    for (double reach = 0;; reach = std::max(2 * reach, grid.box(own).size().maxCoeff())) {
        int nearest = -1;
        double least = std::numeric_limits<double>::infinity();
        const auto consider = [&](int cell) {
            if (!(elements.fraction[static_cast<std::size_t>(cell)] > 0)) return;
            const double distance = (p - clamped(p, grid.box(cell))).norm();
            if (distance > least || (distance == least && cell != own)) return;
            least = distance;
            nearest = cell;
        };
        grid.for_cells_in({p - Vec2::Constant(reach), p + Vec2::Constant(reach)}, consider);
        if (least <= reach || reach > most) return nearest;
    }
}

/// Of pieces in cells of several elements: the element of the piece's own contour, or where that is in another cell (the piece
/// lies on the cell's side) or does not count, of the point just inside.
void find_elements_of_pieces(Elements& elements, const Part& part, const CutCells& cells) {
    constexpr int not_yet = -2;
    for (const BoundaryPiece& piece : cells.pieces)
        elements.of_piece.push_back(piece.cell >= 0 && is_split(elements, piece.cell) ? not_yet : piece.cell);
    if (elements.cell_of_extra.empty()) return;
    for (std::size_t k = 0; k < cells.contours.size(); ++k) {
        const ContourPiece& contour = cells.contours[k];
        if (contour.edge < 0 || elements.of_contour[k] < 0) continue;
        const BoundaryPiece& piece = piece_at(cells, contour.edge, contour.t0);
        int& element = elements.of_piece[static_cast<std::size_t>(&piece - cells.pieces.data())];
        if (element == not_yet && piece.cell == contour.cell) element = elements.of_contour[k];
    }
    for (std::size_t k = 0; k < cells.pieces.size(); ++k) {
        const BoundaryPiece& piece = cells.pieces[k];
        if (elements.of_piece[k] != not_yet) continue;
        const Curve& curve = part.edges[static_cast<std::size_t>(piece.edge)].curve;
        const double t = 0.5 * (piece.t0 + piece.t1);
        const Vec2 inside = point(curve, t) - cells.merge * outward_normal(curve, t);
        elements.of_piece[k] = element_in_cell(part, cells, elements, piece.cell, inside);
    }
}

}  // namespace

Elements find_elements(const Part& part, const CutCells& cells) {
    Elements elements;
    elements.fraction = cells.fraction;
    elements.of_contour.reserve(cells.contours.size());
    for (const ContourPiece& c : cells.contours)
        elements.of_contour.push_back(cells.cell_class[static_cast<std::size_t>(c.cell)] == CellClass::outer ? -1 : c.cell);
    const double crossing_length = crossing_fraction * cells.merge;
    const std::vector<int> loop_of = loops_of_edges(part);
    ElementSides sides;
    sides.first.push_back(0);
    std::vector<int> n_elements;
    CellTrace trace;
    for (std::size_t c = 0; c < cells.cell_class.size(); ++c) {
        if (cells.cell_class[c] != CellClass::boundary) continue;
        trace_cell(trace, part, cells, loop_of, static_cast<int>(c));
        add_cell(elements, sides, cells, static_cast<int>(c), trace);
        n_elements.push_back(trace.n_components());
    }
    elements.neighbours = element_links(cells, sides, n_elements, crossing_length);
    find_elements_of_pieces(elements, part, cells);
    return elements;
}

int element_at(const Part& part, const CutCells& cells, const Elements& elements, const Vec2& p) {
    const int cell = nearest_cell_with_material(cells, elements, p);
    return cell < 0 ? cell : element_in_cell(part, cells, elements, cell, p);
}

}  // namespace abut::geometry
