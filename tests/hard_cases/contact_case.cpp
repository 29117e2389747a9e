// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard_cases/contact_case.hpp"

#include <algorithm>
#include <cmath>

namespace abut::test {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

geometry::Box2 turned_box(const geometry::Part& part, double angle) {
    const Frame frame{std::cos(angle), std::sin(angle), {0, 0}};
    return bounding_box(transformed(part, frame.c, -frame.s, {0, 0}));
}

GridOptions& grid_options(ContactCase& c, int part, double angle) {
    GridOptions& options = c.scene.accuracy.grids[c.scene.parts[at(part)].name];
    options = {};
    options.angle = angle;
    return options;
}

}  // namespace

int add_part(ContactCase& c, const geometry::Part& part, double E, double nu) {
    const int index = static_cast<int>(c.scene.parts.size());
    const std::string name = std::to_string(index);
    c.scene.materials.push_back({name, E, nu, 0, false, {}, false});
    c.scene.parts.push_back({name, part, index, 1, "/parts/" + name});
    c.scene.parts.back().part.name = name;
    return index;
}

void set_even_grid(ContactCase& c, int part, double h, const Vec2& begin, double angle) {
    GridOptions& options = grid_options(c, part, angle);
    const geometry::Box2 box = turned_box(c.scene.parts[at(part)].part, angle);
    for (int axis : {0, 1}) {
        std::vector<double>& lines = axis == 0 ? options.x : options.y;
        double line = begin[axis] + h * std::floor((box.min[axis] - begin[axis]) / h);
        for (; line < box.max[axis]; line += h) lines.push_back(line);
        lines.push_back(line);
    }
}

void set_graded_grid(ContactCase& c, int part, const geometry::Box2& box, double h, double angle) {
    GridOptions& options = grid_options(c, part, angle);
    const geometry::Box2 all = turned_box(c.scene.parts[at(part)].part, angle);
    const double largest = 0.1 * all.diagonal();
    options.x = graded_lines(all.min.x(), all.max.x(), 0, largest, {{box, h}});
    options.y = graded_lines(all.min.y(), all.max.y(), 1, largest, {{box, h}});
}

void set_graded_grid(ContactCase& c, int part, const geometry::Box2& box, double h, double angle, const GridPlace& place) {
    GridOptions& options = grid_options(c, part, angle);
    const geometry::Box2 all = turned_box(c.scene.parts[at(part)].part, angle);
    const double largest = 0.1 * all.diagonal();
    for (int axis : {0, 1}) {
        std::vector<double>& lines = axis == 0 ? options.x : options.y;
        lines = graded_lines(all.min[axis] - 2 * largest, all.max[axis] + 2 * largest, axis, largest, {{box, h}});
        const auto above = std::upper_bound(lines.begin(), lines.end(), place.through[axis]);
        const double move = place.through[axis] - place.below[axis] * h - *(above - 1);
        for (double& v : lines) v += move;
        while (lines.size() > 2 && lines[1] <= all.min[axis]) lines.erase(lines.begin());
        while (lines.size() > 2 && lines[lines.size() - 2] >= all.max[axis]) lines.pop_back();
    }
}

void clamp(ContactCase& c, int part, int edge, bool x, bool y) {
    Support support;
    support.x = x;
    support.y = y;
    support.where = "/supports/" + std::to_string(c.scene.supports.size());
    c.scene.supports.push_back(support);
    c.conditions.supports.push_back({{part, edge, 0, 1}});
}

void press(ContactCase& c, int part, int edge, double pressure) {
    Load load;
    load.kind = Load::Kind::pressure;
    load.value[0] = Expression(pressure);
    load.where = "/loads/" + std::to_string(c.scene.loads.size());
    c.scene.loads.push_back(load);
    c.conditions.loads.push_back({{part, edge, 0, 1}});
}

void push(ContactCase& c, int part, const Vec2& force) {
    Load load;
    load.kind = Load::Kind::part_force;
    load.part = c.scene.parts[at(part)].name;
    load.value = {Expression(force.x()), Expression(force.y())};
    load.where = "/loads/" + std::to_string(c.scene.loads.size());
    c.scene.loads.push_back(load);
    c.conditions.loads.emplace_back();
}

SolvedAssembly solve_case(const ContactCase& c, double search) {
    Stopwatches seconds;
    const std::size_t n = c.scene.parts.size();
    return solve_pass(c.scene, c.conditions, find_candidates(c.scene, search), std::vector<bool>(n, true), WantedSizes(n), 1,
                      seconds);
}

void scale_loads(SolvedAssembly& solved, double factor) {
    for (solver::PartSystem& part : solved.problem.parts) {
        part.load *= factor;
        part.applied *= factor;
    }
    solved.problem.load_scale *= std::abs(factor);
    solve_again(solved);
}

void solve_again(SolvedAssembly& solved) {
    solved.solution = solve_assembly(solved.problem);
    solved.stretches.assign(solved.contacts.size(), {});
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        if (solved.interface_of[k] >= 0 && solved.solution.mechanism.empty())
            solved.stretches[k] = pressed_stretches(solved.contacts[k].face.pressure, pressure_of(solved, k));
}

ContactForce force_on_first(const SolvedAssembly& solved, std::size_t contact) {
    ContactForce sum;
    if (solved.interface_of[contact] < 0) return sum;
    const solver::Interface& face = solved.contacts[contact].face;
    const PartOnGrid& first = solved.grids[at(face.part[0])];
    for (const solver::InterfacePoint& p : face.points) {
        const double pressure = solver::pressure_at(face.pressure, pressure_of(solved, contact), p.s);
        const Vec2 x = first.frame.to_global(p.x[0]),
                   f = -p.weight * face.thickness * pressure * first.frame.vector_to_global(p.normal[0]);
        sum.force += f;
        sum.moment += x.x() * f.y() - x.y() * f.x();
    }
    return sum;
}

double unbalance(const SolvedAssembly& solved, double size) {
    double worst = 0;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const solver::PartSystem& part = solved.problem.parts[i];
        if (!part.supports.empty()) continue;
        const solver::SplineSpace& space = solved.grids[i].input.space;
        const solver::Resultant sum = resultant_of(space, solved.solution.load[i]);
        const double scale =
            std::max(resultant_of(space, part.load).force.norm(), solved.solution.contact_load[i].cwiseAbs().maxCoeff());
        if (scale > 0) worst = std::max({worst, sum.force.norm() / scale, std::abs(sum.moment) / size / scale});
    }
    return worst;
}

double peak_pressure(const SolvedAssembly& solved, std::size_t contact) {
    if (solved.interface_of[contact] < 0) return 0;
    const solver::KnotVector& k = solved.contacts[contact].face.pressure;
    constexpr int samples = 4;
    double peak = 0;
    for (std::size_t i = 0; i + 1 < k.breakpoints.size(); ++i)
        for (int q = 0; q < samples; ++q) {
            const double s = k.breakpoints[i] + (k.breakpoints[i + 1] - k.breakpoints[i]) * q / (samples - 1);
            peak = std::max(peak, solver::pressure_at(k, pressure_of(solved, contact), s));
        }
    return peak;
}

}  // namespace abut::test
