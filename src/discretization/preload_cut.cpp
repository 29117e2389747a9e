// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/preload_cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/splines/element_graph.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

enum class Side : char { none, cut, first, second };

/// The line across the part, in the grid's frame; n points from the first side to the second.
struct Cut {
    Vec2 from, to, n;
    bool is_beyond(const Vec2& x) const { return (x - from).dot(n) > 0; }
};

Cut cut_of(const Load& load, const Frame& frame) {
    const Vec2 a = frame.to_local(load.across[0]), b = frame.to_local(load.across[1]), along = (b - a).normalized();
    return {a, b, Vec2(-along.y(), along.x())};
}

/// The box of an element's cell.
geometry::Box2 box_of(const PartOnGrid& g, int element) {
    return g.cells.grid.box(g.elements.cell_of(element));
}

Vec2 middle_of(const PartOnGrid& g, int element) {
    const geometry::Box2 box = box_of(g, element);
    return 0.5 * (box.min + box.max);
}

/// Does the line meet the box? The parts of the line inside the box' slabs overlap.
bool meets(const Cut& cut, const geometry::Box2& box) {
    double begin = 0, end = 1;
    const Vec2 d = cut.to - cut.from;
    for (int c : {0, 1}) {
        if (d[c] == 0) {
            if (cut.from[c] < box.min[c] || cut.from[c] > box.max[c]) return false;
            continue;
        }
        const double t0 = (box.min[c] - cut.from[c]) / d[c], t1 = (box.max[c] - cut.from[c]) / d[c];
        begin = std::max(begin, std::min(t0, t1));
        end = std::min(end, std::max(t0, t1));
    }
    return begin <= end;
}

/// The side of every element; empty where some hang together past the cut, or nothing is on one of its sides.
std::vector<Side> sides_of(const PartOnGrid& g, const Cut& cut) {
    const solver::SplineSpace& space = g.input.space;
    const solver::ElementGraph graph(space.columns(), space.rows(), space.fraction, space.splits, space.tree.get());
    std::vector<Side> side(at(graph.n_elements()), Side::none);
    for (int e = 0; e < graph.n_elements(); ++e)
        if (graph.has_material(e) && meets(cut, box_of(g, e))) side[at(e)] = Side::cut;
    std::vector<int> open;
    bool is_parted = true;
    const auto take = [&](int e, Side s) {
        if (side[at(e)] == Side::cut) return;
        is_parted = is_parted && (side[at(e)] == Side::none || side[at(e)] == s);
        if (side[at(e)] == Side::none) open.push_back(e);
        side[at(e)] = s;
    };
    for (int e = 0; e < graph.n_elements(); ++e)
        if (side[at(e)] == Side::cut)
            graph.for_neighbours(
                e, [&](int other) { take(other, cut.is_beyond(middle_of(g, other)) ? Side::second : Side::first); });
    while (!open.empty() && is_parted) {
        const int e = open.back();
        open.pop_back();
        graph.for_neighbours(e, [&](int other) { take(other, side[at(e)]); });
    }
    const auto has = [&](Side s) { return std::find(side.begin(), side.end(), s) != side.end(); };
    return is_parted && has(Side::first) && has(Side::second) ? side : std::vector<Side>{};
}

/// Is a function on the second side? It is where the nearest of its elements is.
std::vector<char> functions_beyond(const PartOnGrid& g, const Cut& cut, const std::vector<Side>& side) {
    const solver::SplineSpace& space = g.input.space;
    std::vector<char> beyond(at(space.n_functions));
    std::vector<double> nearest(at(space.n_functions), std::numeric_limits<double>::infinity());
    for (int e = 0; e < static_cast<int>(side.size()); ++e) {
        if (side[at(e)] == Side::none) continue;
        for (int f : extraction(space, e).functions) {
            const Vec2 x = greville_point(space, f);
            const double distance = (x - middle_of(g, e)).squaredNorm();
            if (distance >= nearest[at(f)]) continue;
            nearest[at(f)] = distance;
            beyond[at(f)] = side[at(e)] == Side::cut ? cut.is_beyond(x) : side[at(e)] == Side::second;
        }
    }
    return beyond;
}

[[noreturn]] void refuse(const Load& load, const std::string& why, const std::string& hint) {
    throw InputError(load.where, "part " + load.part + " cannot be tightened across this line: " + why, hint);
}

Eigen::VectorXd pull_displacement(const Load& load, const PartOnGrid& g) {
    const Cut cut = cut_of(load, g.frame);
    const std::vector<Side> side = sides_of(g, cut);
    if (side.empty())
        refuse(load, "it does not part it in two",
               "let both its ends lie outside, right across the shank, so that nothing else joins the two sides");
    const std::vector<char> beyond = functions_beyond(g, cut, side);
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(2 * g.input.space.n_functions);
    for (int f = 0; f < g.input.space.n_functions; ++f)
        if (beyond[at(f)]) pull.segment<2>(2 * f) = -coefficient_of_one(g.input.space, f) * cut.n;
    return pull;
}

}  // namespace

std::vector<const Load*> preloads_on(const Scene& scene, int part) {
    std::vector<const Load*> preloads;
    for (const Load& load : scene.loads_of_all_cases.empty() ? scene.loads : scene.loads_of_all_cases)
        if (load.kind == Load::Kind::preload && load.part == scene.parts[at(part)].name) preloads.push_back(&load);
    return preloads;
}

std::vector<Eigen::VectorXd> pull_displacements(const Scene& scene, const PartOnGrid& on_grid) {
    std::vector<Eigen::VectorXd> pulls;
    for (const Load* load : preloads_on(scene, on_grid.part)) {
        if (on_grid.is_rigid) refuse(*load, "it is rigid", "give it an elastic material");
        if (on_grid.input.is_projected)
            refuse(*load, "it is nearly incompressible", "take plane stress, or a Poisson's ratio below the limit");
        if (on_grid.input.structure) refuse(*load, "it is held by weight functions", "take accuracy.dirichlet \"nitsche\"");
        if (on_grid.input.axis && load->across[0].y() != load->across[1].y())
            refuse(*load, "around an axis its sides can move along the axis only", "give both ends the same y");
        pulls.push_back(pull_displacement(*load, on_grid));
    }
    return pulls;
}

}  // namespace abut
