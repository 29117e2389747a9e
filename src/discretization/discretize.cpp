// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/discretize.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/brep/monotone.hpp"
#include "geometry/curves/gauss.hpp"
#include "geometry/quadrature/transformed_gauss.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/discretization/around_axis.hpp"
#include "src/plan/plan.hpp"
#include "src/scene/dissertation_method.hpp"

namespace abut {

namespace {

/// Largest relative difference between the area of the cells and that of the part before the grid counts as missing some of it.
constexpr double area_tolerance = 1e-9;

/// Rules around an axis are those of splines of so many degrees more: one for the factor r, one for 1 / r, which is no
/// polynomial beyond the first column of cells.
constexpr int degrees_for_radius = 2;

solver::Elasticity elasticity_of(const Scene& scene, const Material& m) {
    // around an axis the same law as in plane strain, with a strain of its own along zz
    return scene.analysis == Analysis::plane_stress ? solver::plane_stress(m.E, m.nu) : solver::plane_strain(m.E, m.nu);
}

solver::Basis basis_of(const Scene& scene) {
    if (scene.accuracy.basis == "plain") return solver::Basis::plain;
    if (scene.accuracy.basis == "normalized") return solver::Basis::normalized;
    return solver::Basis::web;
}

constexpr int outline_points = 8;  // on a piece of boundary, of which the normalized basis takes the largest value

/// Points of an element's boundary: along the part's edges in it, and where these meet the grid. A B-spline that lives in one
/// cell only rises steadily towards that cell's inner corner, so that it is largest on the boundary.
std::vector<Vec2> outline_of(const PartOnGrid& g, int element) {
    const auto cell = static_cast<std::size_t>(g.elements.cell_of(element));
    std::vector<Vec2> points;
    for (int k = g.cells.first_contour[cell]; k < g.cells.first_contour[cell + 1]; ++k) {
        const auto c = static_cast<std::size_t>(k);
        const geometry::ContourPiece& piece = g.cells.contours[c];
        if (g.elements.of_contour[c] != element) continue;
        for (int i = 0; i <= outline_points; ++i) {
            const double t = piece.t0 + (piece.t1 - piece.t0) * i / outline_points;
            points.push_back(piece.edge < 0 ? Vec2(g.cells.grid.box(piece.cell).max.x(), t)
                                            : point(g.local.edges[static_cast<std::size_t>(piece.edge)].curve, t));
        }
    }
    return points;
}

/// `on_grid` must outlive what is returned.
solver::SpaceInput space_input(const Scene& scene, const PartOnGrid& on_grid, std::array<int, 2> degree) {
    const geometry::Grid& grid = on_grid.cells.grid;
    return {solver::clamped_knots(grid.x, degree[0]),
            solver::clamped_knots(grid.y, degree[1]),
            on_grid.elements.fraction,
            {on_grid.elements.cell_of_extra, on_grid.elements.neighbours},
            basis_of(scene),
            [&on_grid](int element) { return outline_of(on_grid, element); },
            grid.tree};
}

}  // namespace

Frame frame_for(const geometry::Part& part, double angle) {
    Frame frame{std::cos(angle), std::sin(angle), {0, 0}};
    frame.shift = bounding_box(transformed(part, frame.c, -frame.s, {0, 0})).center();
    return frame;
}

PartOnGrid discretize(const Scene& scene, int part, const Frame& frame, const geometry::Grid& grid, std::array<int, 2> degree) {
    ENSURE(part >= 0 && at(part) < scene.parts.size(), "the part is one of the scene");
    ENSURE(grid.x.size() > 1 && grid.y.size() > 1, "a grid has cells");
    ENSURE(degree[0] >= 1 && degree[1] >= 1, "displacements are of a degree");
    const ScenePart& source = scene.parts[static_cast<std::size_t>(part)];
    PartOnGrid result;
    result.part = part;
    result.frame = frame;
    result.local = transformed(source.part, frame.c, -frame.s, -frame.shift);
    result.cells = cut_cells(result.local, grid);
    result.area = area(result.local);
    result.size = bounding_box(result.local).diagonal();
    result.center = centroid(result.local);
    if (std::abs(result.cells.area - result.area) > area_tolerance * result.area)
        throw InputError(source.where, "the grid given for part " + source.name + " does not cover it",
                         "extend its knots over the part's bounding box");

    const bool is_ring = scene.analysis == Analysis::axisymmetric;
    // the radius takes part in every integral around an axis
    const int p = std::max(degree[0], degree[1]) + (is_ring ? degrees_for_radius : 0);
    solver::PartInput& input = result.input;
    result.elements = find_elements(result.local, result.cells);
    input.space = make_space(space_input(scene, result, degree));
    for (geometry::CellRule& rule : is_by_dissertation(scene)
                                        ? transformed_rules(result.local, result.cells, result.elements, p)
                                        : cell_rules(result.local, result.cells, result.elements, p))
        input.cut_rules.push_back({rule.element, std::move(rule.points), std::move(rule.weights)});
    const geometry::GaussRule& line = geometry::gauss_rule(p + 1);
    input.line_rule = {line.points, line.weights};
    const Material& material = scene.materials[static_cast<std::size_t>(source.material)];
    input.elasticity = elasticity_of(scene, material);
    input.is_projected = is_nearly_incompressible(scene, material);
    input.thickness = source.thickness;
    input.by_cholmod = scene.accuracy.by_cholmod;
    if (is_ring) put_around_axis(scene, result);
    return result;
}

PartOnGrid copied(const Scene& scene, int part, const Frame& frame, const PartOnGrid& model) {
    ENSURE(part >= 0 && at(part) < scene.parts.size() && part != model.part, "the copy is another part of the scene");
    const geometry::Part& source = scene.parts[at(part)].part;
    ENSURE(source.edges.size() == model.local.edges.size(), "a copy has its model's edges");
    PartOnGrid copy = model;
    copy.part = part;
    copy.model = model.part;
    copy.frame = frame;
    copy.local.name = source.name;  // places are the model's to the last bit, so that it does not matter who asks first
    for (std::size_t k = 0; k < source.edges.size(); ++k) copy.local.edges[k].name = source.edges[k].name;
    return copy;
}

int element_in(const PartOnGrid& on_grid, int cell, const Vec2& local) {
    const std::vector<int>& split = on_grid.elements.cell_of_extra;
    if (!std::binary_search(split.begin(), split.end(), cell)) return cell;
    return element_at(on_grid.local, on_grid.cells, on_grid.elements, local);
}

namespace {

std::vector<std::pair<int, Vec2>> make_cut_samples(const PartOnGrid& on_grid) {
    // as many as the fit has coefficients in a cell, so that even a quarter of one, alone, determines them
    const int degree = std::max(on_grid.input.space.x.degree, on_grid.input.space.y.degree);
    const geometry::GaussRule &line = geometry::gauss_rule(degree + 1), &along = geometry::gauss_rule(std::max(2, degree));
    const auto pieces = geometry::monotone_pieces(on_grid.local);
    std::vector<std::pair<int, Vec2>> samples;
    for (std::size_t c = 0; c < on_grid.cells.cell_class.size(); ++c) {
        if (on_grid.cells.cell_class[c] != geometry::CellClass::boundary) continue;
        const geometry::Box2 box = on_grid.cells.grid.box(static_cast<int>(c));
        for (double v : line.points)
            for (double u : line.points) {
                const Vec2 p = box.min + Vec2(u, v).cwiseProduct(box.size());
                if (contains(pieces, p)) samples.emplace_back(element_in(on_grid, static_cast<int>(c), p), p);
            }
    }
    for (std::size_t k = 0; k < on_grid.cells.pieces.size(); ++k) {
        const geometry::BoundaryPiece& piece = on_grid.cells.pieces[k];
        if (on_grid.cells.cell_class[static_cast<std::size_t>(piece.cell)] != geometry::CellClass::boundary) continue;
        const geometry::Curve& curve = on_grid.local.edges[static_cast<std::size_t>(piece.edge)].curve;
        for (double u : along.points)
            samples.emplace_back(on_grid.elements.of_piece[k], point(curve, piece.t0 + u * (piece.t1 - piece.t0)));
    }
    return samples;
}

}  // namespace

const std::vector<std::pair<int, Vec2>>& cut_cell_samples(const PartOnGrid& on_grid) {
    return on_grid.cut_samples([&] { return make_cut_samples(on_grid); });
}

}  // namespace abut
