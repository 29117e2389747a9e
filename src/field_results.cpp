// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/field_results.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/gauss.hpp"
#include "solver/local_spline.hpp"

namespace abut {

namespace {

using geometry::CellClass;

constexpr double drawn_arc = 0.06;  // radians of turning between points of a drawn edge

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Patches a side of a cell: few cells are drawn finer than many.
int patches_per_side(std::size_t n_cells) {
    return n_cells < 300 ? 4 : (n_cells < 1500 ? 2 : 1);
}

/// Stress turned from the grid's axes to the assembly's.
Stress turned(const Eigen::Vector4d& s, const Frame& f) {
    const double c = f.c, q = f.s;
    return {c * c * s[0] + q * q * s[1] - 2 * c * q * s[2], q * q * s[0] + c * c * s[1] + 2 * c * q * s[2],
            c * q * (s[0] - s[1]) + (c * c - q * q) * s[2], s[3]};
}

/// Fields of a part at points, of which those of one element in turn share what can be shared.
class FieldSampler {
public:
    FieldSampler(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress)
        : grid_(grid), displacement_(displacement), stress_(stress) {}

    FieldSample operator()(int element, const Vec2& local) {
        if (element != element_) take(element);
        const Vec2 u =
            moved_ ? moved_->value(local) : solver::displacement_at(grid_.input, displacement_, element, local).value;
        return {grid_.frame.to_global(local), grid_.frame.vector_to_global(u),
                turned(pressed_ ? solver::stress_at(stress_, *pressed_, element, local)
                                : solver::stress_at(stress_, element, local),
                       grid_.frame)};
    }

private:
    void take(int element) {
        element_ = element;
        if (!grid_.input.structure)
            moved_.emplace(grid_.input.space, element, [&](int f) { return displacement_.segment<2>(2 * f); });
        if (stress_.failure.empty()) pressed_.emplace(local_stress(stress_, element));
    }

    const PartOnGrid& grid_;
    const Eigen::VectorXd& displacement_;
    const solver::StressField& stress_;
    int element_ = -1;
    std::optional<solver::LocalSpline<2>> moved_;    // without a solution structure
    std::optional<solver::LocalSpline<3>> pressed_;  // where there are stresses
};

void take_maximum(PartFieldResult& r, const FieldSample& sample) {
    const double u = sample.displacement.norm(), v = von_mises(sample.stress);
    if (u > r.max_displacement.value) r.max_displacement = {u, sample.at};
    if (v > r.max_von_mises.value) r.max_von_mises = {v, sample.at};
}

template <class Sample>
void add_cell(PartFieldResult& r, const PartOnGrid& grid, int cell, int n, Sample sample) {
    const geometry::Grid& lines = grid.cells.grid;
    const auto i = at(lines.column_of(cell)), j = at(lines.row_of(cell));
    const int base = static_cast<int>(r.field.samples.size());
    for (int b = 0; b <= n; ++b)
        for (int a = 0; a <= n; ++a)
            r.field.samples.push_back(sample(
                Vec2(lines.x[i] + (lines.x[i + 1] - lines.x[i]) * a / n, lines.y[j] + (lines.y[j + 1] - lines.y[j]) * b / n)));
    for (int b = 0; b < n; ++b)
        for (int a = 0; a < n; ++a) {
            const int k = base + b * (n + 1) + a;
            r.field.patches.push_back({{k, k + 1, k + n + 2, k + n + 1}});
        }
}

}  // namespace

solver::StressField stress_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement) {
    if (grid.is_rigid) {
        solver::StressField none;
        none.space = grid.input.space;
        none.coefficients = Eigen::MatrixX3d::Zero(grid.input.space.n_functions, 3);
        return none;
    }
    std::vector<solver::SamplePoint> cut;
    for (const auto& [element, x] : cut_cell_samples(grid)) cut.push_back({element, x});
    const int degree = std::max(grid.input.space.x.degree, grid.input.space.y.degree);
    return solver::fit_stress(grid.input, displacement, geometry::gauss_rule(degree).points, cut);
}

FieldSample sample_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress,
                         int element, const Vec2& local) {
    return FieldSampler(grid, displacement, stress)(element, local);
}

PartFieldResult part_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress) {
    PartFieldResult r;
    FieldSampler sample(grid, displacement, stress);
    const int n = patches_per_side(grid.cells.cell_class.size());
    for (std::size_t c = 0; c < grid.cells.cell_class.size(); ++c) {
        if (grid.cells.cell_class[c] == CellClass::outer) continue;
        const std::size_t before = r.field.samples.size();
        const int cell = static_cast<int>(c);
        add_cell(r, grid, cell, n, [&](const Vec2& p) { return sample(element_in(grid, cell, p), p); });
        if (grid.cells.cell_class[c] == CellClass::inner)
            for (std::size_t k = before; k < r.field.samples.size(); ++k) take_maximum(r, r.field.samples[k]);
    }
    for (const auto& [element, p] : cut_cell_samples(grid)) take_maximum(r, sample(element, p));
    for (const geometry::Loop& loop : grid.local.loops) {
        r.field.boundary.emplace_back();
        for (int e : loop.edges)
            for (int k = grid.cells.first_piece[at(e)]; k < grid.cells.first_piece[at(e) + 1]; ++k) {
                const geometry::BoundaryPiece& piece = grid.cells.pieces[at(k)];
                const geometry::Curve& curve = grid.local.edges[at(e)].curve;
                const double angle = turning(curve, piece.t0, piece.t1);
                const int steps = std::max(1, static_cast<int>(std::ceil(angle / drawn_arc)));
                for (int q = 0; q < steps; ++q) {
                    const double t = piece.t0 + (piece.t1 - piece.t0) * q / steps;
                    r.field.boundary.back().push_back(sample(grid.elements.of_piece[at(k)], point(curve, t)));
                    take_maximum(r, r.field.boundary.back().back());
                }
            }
    }
    return r;
}

}  // namespace abut
