// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretize.hpp"

#include <cmath>
#include <utility>

#include "geometry/gauss.hpp"
#include "geometry/monotone.hpp"

namespace abut {

namespace {

/// Largest relative difference between the area of the cells and that of the part before the grid counts as missing some of it.
constexpr double area_tolerance = 1e-9;

solver::Elasticity elasticity_of(const Scene& scene, const Material& m) {
    return scene.analysis == Analysis::plane_strain ? solver::plane_strain(m.E, m.nu) : solver::plane_stress(m.E, m.nu);
}

}  // namespace

Frame frame_for(const geometry::Part& part, double angle) {
    Frame frame{std::cos(angle), std::sin(angle), {0, 0}};
    frame.shift = bounding_box(transformed(part, frame.c, -frame.s, {0, 0})).center();
    return frame;
}

PartOnGrid discretize(const Scene& scene, int part, const Frame& frame, const geometry::Grid& grid, std::array<int, 2> degree) {
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

    const int p = std::max(degree[0], degree[1]);
    solver::PartInput& input = result.input;
    const auto basis = scene.accuracy.basis == "plain" ? solver::Basis::plain : solver::Basis::web;
    input.space = solver::make_space(grid.x, grid.y, degree[0], degree[1], result.cells.fraction, basis);
    for (geometry::CellRule& rule : cell_rules(result.local, result.cells, p))
        input.cut_rules.push_back({rule.cell, std::move(rule.points), std::move(rule.weights)});
    const geometry::GaussRule& line = geometry::gauss_rule(p + 1);
    input.line_rule = {line.points, line.weights};
    input.elasticity = elasticity_of(scene, scene.materials[static_cast<std::size_t>(source.material)]);
    input.thickness = source.thickness;
    return result;
}

std::vector<std::pair<int, Vec2>> cut_cell_samples(const PartOnGrid& on_grid) {
    const geometry::Grid& grid = on_grid.cells.grid;
    const geometry::GaussRule& line = geometry::gauss_rule(3);
    const auto pieces = geometry::monotone_pieces(on_grid.local);
    std::vector<std::pair<int, Vec2>> samples;
    for (std::size_t c = 0; c < on_grid.cells.cell_class.size(); ++c) {
        if (on_grid.cells.cell_class[c] != geometry::CellClass::boundary) continue;
        const auto i = static_cast<std::size_t>(grid.column_of(static_cast<int>(c)));
        const auto j = static_cast<std::size_t>(grid.row_of(static_cast<int>(c)));
        for (double v : line.points)
            for (double u : line.points) {
                const Vec2 p(grid.x[i] + u * (grid.x[i + 1] - grid.x[i]), grid.y[j] + v * (grid.y[j + 1] - grid.y[j]));
                if (contains(pieces, p)) samples.emplace_back(static_cast<int>(c), p);
            }
    }
    for (const geometry::BoundaryPiece& piece : on_grid.cells.pieces) {
        if (on_grid.cells.cell_class[static_cast<std::size_t>(piece.cell)] != geometry::CellClass::boundary) continue;
        const geometry::Curve& curve = on_grid.local.edges[static_cast<std::size_t>(piece.edge)].curve;
        for (double u : geometry::gauss_rule(2).points)
            samples.emplace_back(piece.cell, point(curve, piece.t0 + u * (piece.t1 - piece.t0)));
    }
    return samples;
}

}  // namespace abut
