// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/answers/field_results.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/curves/gauss.hpp"
#include "solver/splines/local_spline.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

using geometry::CellClass;

constexpr double drawn_arc = 0.06;  // radians of turning between points of a drawn edge

constexpr int most_patches = 256;  // along a side of a cell

/// Patches a side of a cell, at least: few cells are drawn finer than many.
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
        : grid_(grid), displacement_(displacement), stress_(stress) {
        ENSURE(displacement.size() == 2 * grid.input.space.n_functions, "a displacement has two numbers for every function");
    }

    FieldSample operator()(int element, const Vec2& local) {
        if (element != element_) take(element);
        const Vec2 u = moved_ ? moved_->value(local) + pulled_at(local)
                              : solver::displacement_at(grid_.input, displacement_, element, local).value;
        return {grid_.frame.to_global(local), grid_.frame.vector_to_global(u),
                turned(pressed_ ? solver::stress_at(stress_, *pressed_, element, local)
                                : solver::stress_at(stress_, element, local),
                       grid_.frame)};
    }

private:
    void take(int element) {
        element_ = element;
        if (!grid_.input.structure)
            moved_.emplace(grid_.input.space, element,
                           [&](int f) { return Vec2(displacement_.segment<2>(2 * f) - pull_of(f)); });
        if (grid_.input.stress_free.size() > 0) take_sides(element);
        if (stress_.failure.empty()) pressed_.emplace(local_stress(stress_, element));
    }

    Vec2 pull_of(int function) const {
        const Eigen::VectorXd& free = grid_.input.stress_free;
        return free.size() > 0 ? Vec2(free.segment<2>(2 * function)) : Vec2(0, 0);
    }

    /// Functions of both sides of a cut reach into the elements around it, where the body changes over on the line.
    void take_sides(int element) {
        const std::vector<int>& functions = extraction(grid_.input.space, element).functions;
        const auto shift_of = [&](int f) { return Vec2(pull_of(f) / coefficient_of_one(grid_.input.space, f)); };
        cut_ = nullptr;
        sides_.fill(shift_of(functions.front()));
        for (std::size_t k = 0; k < grid_.cuts.size(); ++k) {
            const auto is_drawn = [&](int f) { return !grid_.input.pulls[k].segment<2>(2 * f).isZero(0); };
            for (const int f : functions) {
                if (is_drawn(f) == is_drawn(functions.front())) continue;
                cut_ = &grid_.cuts[k];
                sides_[is_drawn(f) ? 1 : 0] = shift_of(f);
            }
        }
    }
    Vec2 pulled_at(const Vec2& local) const {
        return sides_[cut_ && geometry::cross((*cut_)[1] - (*cut_)[0], local - (*cut_)[0]) > 0 ? 1 : 0];
    }

    const PartOnGrid& grid_;
    const Eigen::VectorXd& displacement_;
    const solver::StressField& stress_;
    int element_ = -1;
    const std::array<Vec2, 2>* cut_ = nullptr;           // through the element, or beside it
    std::array<Vec2, 2> sides_{Vec2(0, 0), Vec2(0, 0)};  // how far those are drawn along it
    std::optional<solver::LocalSpline<2>> moved_;        // without a solution structure
    std::optional<solver::LocalSpline<3>> pressed_;      // where there are stresses
};

int steps_along(const geometry::Curve& curve, double t0, double t1) {
    return std::max(1, static_cast<int>(std::ceil(turning(curve, t0, t1) / drawn_arc)));
}

/// visit(element, local) along a loop, as finely as it is drawn.
template <class Visit>
void walk_along(const PartOnGrid& grid, const geometry::Loop& loop, const Visit& visit) {
    for (int e : loop.edges)
        for (int k = grid.cells.first_piece[at(e)]; k < grid.cells.first_piece[at(e) + 1]; ++k) {
            const geometry::BoundaryPiece& piece = grid.cells.pieces[at(k)];
            const geometry::Curve& curve = grid.local.edges[at(e)].curve;
            const int steps = steps_along(curve, piece.t0, piece.t1);
            for (int q = 0; q < steps; ++q)
                visit(grid.elements.of_piece[at(k)], point(curve, piece.t0 + (piece.t1 - piece.t0) * q / steps));
        }
}

/// A chord of the boundary in a cell, the part on its left.
struct Chord {
    Vec2 from, to;
    int element;
};

/// How a point lies to a cell's chords: the nearest of them, the point of it that is nearest, and whether that is to the right.
struct Nearest {
    const Chord* chord = nullptr;
    Vec2 at{0, 0};
    bool outside = false;
};

/// Of two chords that are as near, by the point they share, the one decides that sees the point less from its end.
Nearest nearest(const std::vector<Chord>& chords, const Vec2& p) {
    Nearest best;
    double least = std::numeric_limits<double>::infinity(), height = 0;
    for (const Chord& chord : chords) {
        const Vec2 along = chord.to - chord.from;
        const double t = std::clamp((p - chord.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const Vec2 foot = t < 1 ? Vec2(chord.from + t * along) : chord.to;
        const double distance = (p - foot).norm(), left = geometry::cross(along, p - chord.from) / along.norm();
        if (distance > least || (distance == least && std::abs(left) <= height)) continue;
        least = distance;
        height = std::abs(left);
        best = {&chord, foot, left < 0};
    }
    return best;
}

/// The patches of one cell.
class CellPatches {
public:
    CellPatches(const PartOnGrid& grid, int cell, int least, double patch) : grid_(grid), cell_(cell) {
        const geometry::Box2 box = grid.cells.grid.box(cell);
        low_ = box.min;
        size_ = box.size();
        for (int axis : {0, 1})
            n_[at(axis)] = std::clamp(static_cast<int>(std::ceil(size_[axis] / patch)), least, most_patches);
    }

    /// In a full cell.
    void add_full(FieldSampler& sample, PartField& field) const {
        const int base = static_cast<int>(field.samples.size());
        for (const Vec2& p : all_nodes()) field.samples.push_back(sample(cell_, p));
        for (int b = 0; b < n_[1]; ++b)
            for (int a = 0; a < n_[0]; ++a) {
                FieldPatch patch{corners(a, b)};
                for (int& k : patch.corner) k += base;
                field.patches.push_back(patch);
            }
    }

    /// In a cut one, or a full one along whose sides the boundary runs.
    void add_cut(FieldSampler& sample, PartField& field) const {
        const std::vector<Chord> chords = chords_of_cell();
        if (chords.empty()) return add_full(sample, field);
        std::vector<bool> drawn = crossed(chords);
        const std::vector<Vec2> nodes = all_nodes();
        std::vector<Nearest> place;
        for (const Vec2& p : nodes) place.push_back(nearest(chords, p));
        std::vector<bool> needed(place.size(), false);
        for (int b = 0; b < n_[1]; ++b)
            for (int a = 0; a < n_[0]; ++a) {
                const std::array<int, 4> corner = corners(a, b);
                const auto is_inside = [&](int k) { return !place[at(k)].outside; };
                const auto p = at(b * n_[0] + a);
                drawn[p] = drawn[p] || std::any_of(corner.begin(), corner.end(), is_inside);
                if (drawn[p])
                    for (int k : corner) needed[at(k)] = true;
            }
        std::vector<int> index(place.size(), -1);
        for (std::size_t k = 0; k < place.size(); ++k) {
            if (!needed[k]) continue;
            index[k] = static_cast<int>(field.samples.size());
            field.samples.push_back(sampled(sample, place[k], nodes[k]));
        }
        for (int b = 0; b < n_[1]; ++b)
            for (int a = 0; a < n_[0]; ++a) {
                if (!drawn[at(b * n_[0] + a)]) continue;
                const std::array<int, 4> corner = corners(a, b);
                field.patches.push_back(
                    {{index[at(corner[0])], index[at(corner[1])], index[at(corner[2])], index[at(corner[3])]}});
            }
    }

private:
    std::vector<Vec2> all_nodes() const {
        std::vector<Vec2> nodes;
        for (int b = 0; b <= n_[1]; ++b)
            for (int a = 0; a <= n_[0]; ++a)
                nodes.push_back(low_ +
                                size_.cwiseProduct(Vec2(static_cast<double>(a) / n_[0], static_cast<double>(b) / n_[1])));
        return nodes;
    }

    std::array<int, 4> corners(int a, int b) const {
        const int k = b * (n_[0] + 1) + a;
        return {k, k + 1, k + n_[0] + 2, k + n_[0] + 1};
    }

    std::vector<Chord> chords_of_cell() const {
        std::vector<Chord> chords;
        for (int k = grid_.cells.first_contour[at(cell_)]; k < grid_.cells.first_contour[at(cell_) + 1]; ++k) {
            const geometry::ContourPiece& piece = grid_.cells.contours[at(k)];
            if (piece.edge < 0 || grid_.elements.of_contour[at(k)] < 0) continue;
            const geometry::Curve& curve = grid_.local.edges[at(piece.edge)].curve;
            const int steps = steps_along(curve, piece.t0, piece.t1);
            Vec2 from = point(curve, piece.t0);
            for (int q = 1; q <= steps; ++q) {
                const Vec2 to = point(curve, piece.t0 + (piece.t1 - piece.t0) * q / steps);
                if (from != to) chords.push_back({from, to, grid_.elements.of_contour[at(k)]});
                from = to;
            }
        }
        return chords;
    }

    /// By patch: does the boundary pass? Chords are looked at in steps of a patch.
    std::vector<bool> crossed(const std::vector<Chord>& chords) const {
        std::vector<bool> passes(at(n_[0] * n_[1]), false);
        for (const Chord& chord : chords) {
            const Vec2 from = (chord.from - low_).cwiseQuotient(size_), to = (chord.to - low_).cwiseQuotient(size_);
            const int steps = 1 + static_cast<int>(std::abs(to.x() - from.x()) * n_[0] + std::abs(to.y() - from.y()) * n_[1]);
            for (int q = 0; q < steps; ++q) {
                const Vec2 p = from + (to - from) * q / steps, r = from + (to - from) * (q + 1) / steps;
                const auto range = [&](int axis) {
                    const auto of = [&](double v) {
                        return std::clamp(static_cast<int>(v * n_[at(axis)]), 0, n_[at(axis)] - 1);
                    };
                    return std::minmax({of(p[axis]), of(r[axis])});
                };
                const std::pair<int, int> columns = range(0), rows = range(1);
                for (int b = rows.first; b <= rows.second; ++b)
                    for (int a = columns.first; a <= columns.second; ++a) passes[at(b * n_[0] + a)] = true;
            }
        }
        return passes;
    }

    /// A corner beyond the boundary is extrapolated from its nearest point, by the slope just inside.
    FieldSample sampled(FieldSampler& sample, const Nearest& place, const Vec2& p) const {
        if (!place.outside) return sample(element_in(grid_, cell_, p), p);
        constexpr double step = 1.0 / 16;  // of the distance
        const int element = place.chord->element;
        const FieldSample on = sample(element, place.at), within = sample(element, place.at + step * (place.at - p));
        const auto beyond = [](double a, double b) { return a + (a - b) / step; };
        FieldSample result;
        result.at = grid_.frame.to_global(p);
        for (int axis : {0, 1}) result.displacement[axis] = beyond(on.displacement[axis], within.displacement[axis]);
        result.stress = {beyond(on.stress.xx, within.stress.xx), beyond(on.stress.yy, within.stress.yy),
                         beyond(on.stress.xy, within.stress.xy), beyond(on.stress.zz, within.stress.zz)};
        return result;
    }

    const PartOnGrid& grid_;
    int cell_;
    Vec2 low_, size_;
    std::array<int, 2> n_{};
};

}  // namespace

solver::StressField stress_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement) {
    if (grid.is_rigid) {
        solver::StressField none;
        none.space = std::make_shared<const solver::SplineSpace>(grid.input.space);
        none.coefficients = Eigen::MatrixX3d::Zero(grid.input.space.n_functions, 3);
        return none;
    }
    std::vector<solver::SamplePoint> cut;
    for (const auto& [element, x] : cut_cell_samples(grid)) cut.push_back({element, x});
    const int degree = std::max(grid.input.space.x.degree, grid.input.space.y.degree);
    return solver::fit_stress(grid.input, displacement, geometry::gauss_rule(degree).points, cut, grid.fit.get());
}

FieldSample sample_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress,
                         int element, const Vec2& local) {
    return FieldSampler(grid, displacement, stress)(element, local);
}

LargestOfPart largest_of_part(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress) {
    LargestOfPart r;
    FieldSampler sample(grid, displacement, stress);
    const auto take = [&](int element, const Vec2& local) {
        const FieldSample s = sample(element, local);
        const double u = s.displacement.norm(), v = von_mises(s.stress);
        if (u > r.displacement.value.value) r.displacement = {{u, s.at}, element, local};
        if (v > r.von_mises.value.value) r.von_mises = {{v, s.at}, element, local};
    };
    const int n = patches_per_side(grid.cells.cell_class.size());
    for (std::size_t c = 0; c < grid.cells.cell_class.size(); ++c) {
        if (grid.cells.cell_class[c] != CellClass::inner) continue;
        const int cell = static_cast<int>(c);
        const geometry::Box2 box = grid.cells.grid.box(cell);
        for (int b = 0; b <= n; ++b)
            for (int a = 0; a <= n; ++a) take(cell, box.min + box.size().cwiseProduct(Vec2(a, b)) / n);
    }
    for (const auto& [element, p] : cut_cell_samples(grid)) take(element, p);
    for (const geometry::Loop& loop : grid.local.loops) walk_along(grid, loop, take);
    return r;
}

PartField part_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress,
                     double patch, std::size_t model_cells) {
    PartField field;
    FieldSampler sample(grid, displacement, stress);
    const int least = patches_per_side(std::max(grid.cells.cell_class.size(), model_cells));
    for (std::size_t c = 0; c < grid.cells.cell_class.size(); ++c) {
        if (grid.cells.cell_class[c] == CellClass::outer) continue;
        const CellPatches patches(grid, static_cast<int>(c), least, patch);
        if (grid.cells.cell_class[c] == CellClass::inner)
            patches.add_full(sample, field);
        else
            patches.add_cut(sample, field);
    }
    for (const geometry::Loop& loop : grid.local.loops) {
        field.boundary.emplace_back();
        walk_along(grid, loop, [&](int element, const Vec2& p) { field.boundary.back().push_back(sample(element, p)); });
    }
    return field;
}

}  // namespace abut
