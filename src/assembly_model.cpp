// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/assembly_model.hpp"

#include <algorithm>
#include <chrono>

#include "solver/parallel_for.hpp"
#include "src/load_vector.hpp"
#include "src/part_grid.hpp"
#include "src/solution_structure.hpp"
#include "src/support_sets.hpp"
#include "src/svg.hpp"

namespace abut {

namespace {

constexpr int max_wall_refinements = 5;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

class Timed {
public:
    Timed(Stopwatches& seconds, std::string stage) : seconds_(seconds), stage_(std::move(stage)) {}
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;
    ~Timed() { seconds_[stage_] += seconds(); }
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

private:
    Stopwatches& seconds_;
    std::string stage_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

PartOnGrid put_on_grid(const Scene& scene, int part, const std::vector<WantedSize>& wanted, double coarseness,
                       SolvedAssembly& solved) {
    bool limited = false;
    double refinement = 1;
    for (int attempt = 0;; ++attempt, refinement *= 0.5) {
        const PartGrid chosen = grid_of_part(scene, part, wanted, coarseness, refinement);
        limited = limited || chosen.limited;
        PartOnGrid g = discretize(scene, part, chosen.frame, chosen.grid, chosen.degree);
        const bool is_final = chosen.given || attempt == max_wall_refinements || scene.accuracy.cell_size;
        if (!is_final && !g.input.space.failure.empty()) continue;
        if (attempt > 0) ++solved.refined_for_walls;
        if (limited) ++solved.limited_grids;
        return g;
    }
}

struct LoadedSystem {
    solver::PartSystem system;
    double load_scale = 0;
};
LoadedSystem make_system(const Scene& scene, const ResolvedConditions& conditions, PartOnGrid& g) {
    g.input.structure = make_structure(scene, conditions, g);
    if (g.input.structure) g.input.is_projected = false;  // they do not go together: a warning says so
    g.input.free_strain = free_strain(scene, g);
    PartLoad load = load_vector(scene, conditions, g);
    return {solver::make_part_system(g.input, support_sets(scene, conditions, g), std::move(load.vector), g.center, g.size,
                                     spring_sets(scene, conditions, g), load.weighted),
            load.scale};
}

/// With dirichlet "aligned" every support of edges has to be imposed that way.
void require_aligned(const Scene& scene, const PartOnGrid& g, const solver::PartSystem& system) {
    for (const solver::SupportRecord& record : system.supports)
        if (scene.accuracy.dirichlet == "aligned" && record.method == solver::SupportMethod::nitsche)
            throw InputError(scene.supports[at(record.set.tag)].where,
                             "this support cannot be imposed by dropping functions: on part " + scene.parts[at(g.part)].name +
                                 " it " + record.why,
                             "set accuracy.dirichlet to \"auto\" or \"nitsche\"");
}

/// Part, place and meaning of a system that cannot be solved.
std::string failure_of(const Scene& scene, const PartOnGrid& g, const solver::PartSystem& system) {
    std::string where;
    if (system.failed_at) {
        const Vec2 x = g.frame.to_global(system.failed_at->at);
        where = ", near (" + number_text(x.x(), 6) + ", " + number_text(x.y(), 6) + ")";
    }
    return "part " + scene.parts[at(g.part)].name + where + ": " + system.failure;
}

/// Solver's input, supports and loads of every part on its grid.
void make_systems(const Scene& scene, const ResolvedConditions& conditions, int threads, SolvedAssembly& solved) {
    std::vector<LoadedSystem> made(solved.grids.size());
    solver::parallel_for(static_cast<int>(made.size()), threads,
                         [&](int i) { made[at(i)] = make_system(scene, conditions, solved.grids[at(i)]); });
    for (std::size_t i = 0; i < made.size(); ++i) {
        PartOnGrid& g = solved.grids[i];
        solved.problem.load_scale = std::max(solved.problem.load_scale, made[i].load_scale);
        solved.problem.parts.push_back(std::move(made[i].system));
        const solver::PartSystem& system = solved.problem.parts.back();
        g.input.dilatation = system.input.dilatation;
        require_aligned(scene, g, system);
        if (!system.failure.empty()) solved.failure = failure_of(scene, g, system);
        for (solver::MeanConstraint& c : mean_constraints(scene, g, static_cast<int>(i)))
            solved.problem.constraints.push_back(std::move(c));
    }
}

/// Wall time of the factorisations: where parts were made side by side, their share of what all of it took.
double factorisation_seconds(const SolvedAssembly& solved, double wall) {
    double all = 0, factorisation = 0;
    for (const solver::PartSystem& system : solved.problem.parts) {
        all += system.seconds.all;
        factorisation += system.seconds.factorisation;
    }
    return all > wall ? factorisation * wall / all : factorisation;
}

void add_steps(const solver::SolveSeconds& steps, Stopwatches& seconds) {
    seconds["rows"] += steps.rows;
    seconds["condensation"] += steps.condensation;
    seconds["contact iterations"] += steps.contact;
    seconds["displacements"] += steps.displacements;
}

/// Index of the solver's new interface.
int append_interface(const ContactInterface& contact, SolvedAssembly& solved) {
    solved.problem.interfaces.push_back(contact.face);
    solved.problem.foundation.push_back(contact.foundation);
    solved.problem.own_normals.push_back(contact.own_normals);
    return static_cast<int>(solved.problem.interfaces.size()) - 1;
}

/// Held as drawn, across the interface.
void bond(ContactInterface& contact) {
    contact.face.bilateral = true;
    for (solver::InterfacePoint& p : contact.face.points) p.gap = 0;
}

/// The same points held along the interface.
ContactInterface turned_along(ContactInterface contact) {
    for (solver::InterfacePoint& p : contact.face.points)
        for (Vec2& n : p.normal) n = geometry::left_of(n);
    for (auto& pair : contact.own_normals)
        for (Vec2& n : pair) n = geometry::left_of(n);
    return contact;
}

void make_interfaces(const Scene& scene, const std::vector<Candidate>& candidates, SolvedAssembly& solved) {
    for (const Candidate& c : candidates) {
        const int a = solved.solver_part[at(c.first)], b = solved.solver_part[at(c.second)];
        solved.interface_of.push_back(-1);
        solved.shear_of.push_back(-1);
        solved.contacts.emplace_back();
        solved.contacts.back().part = {c.first, c.second};
        if (a < 0 || b < 0) continue;
        solved.contacts.back() = make_interface(scene, c, solved.grids[at(a)], solved.grids[at(b)], {a, b});
        ContactInterface& contact = solved.contacts.back();
        if (contact.face.points.empty()) continue;
        if (c.bonded) bond(contact);
        solved.interface_of.back() = append_interface(contact, solved);
        if (c.bonded) solved.shear_of.back() = append_interface(turned_along(contact), solved);
    }
}

/// Tells the parts where their interfaces are.
void note_contact_elements(SolvedAssembly& solved) {
    for (const solver::Interface& face : solved.problem.interfaces)
        for (std::size_t side = 0; side < 2; ++side) {
            std::vector<int>& elements = solved.grids[at(face.part[side])].input.contact_elements;
            for (const solver::InterfacePoint& p : face.points)
                if (elements.empty() || elements.back() != p.element[side]) elements.push_back(p.element[side]);
        }
}

/// Bonded edges hold wherever they face each other.
std::vector<ContactRun> runs_of(const SolvedAssembly& solved, std::size_t contact) {
    const solver::Interface& face = solved.contacts[contact].face;
    if (!face.bilateral) return contact_runs(face.pressure, pressure_of(solved, contact));
    return {{face.pressure.breakpoints.front(), face.pressure.breakpoints.back(), true, true}};
}

/// Displacements, pressures and stretches of contact, on systems that are factorised.
void solve_contacts(SolvedAssembly& solved, Stopwatches& seconds, int threads) {
    const Timed timed(seconds, "solve");
    solved.solution = solve_assembly(solved.problem, threads);
    add_steps(solved.solution.seconds, seconds);
    solved.runs.assign(solved.contacts.size(), {});
    if (!solved.solution.mechanism.empty()) return;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        if (solved.interface_of[k] >= 0) solved.runs[k] = runs_of(solved, k);
}

}  // namespace

SolvedAssembly solve_pass(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                          const std::vector<bool>& solve_part, const WantedSizes& wanted, double coarseness,
                          Stopwatches& seconds, int threads) {
    SolvedAssembly solved;
    solved.solver_part.assign(scene.parts.size(), -1);
    {
        const Timed timed(seconds, "geometry");
        for (std::size_t i = 0; i < scene.parts.size(); ++i) {
            if (!solve_part[i]) continue;
            solved.solver_part[i] = static_cast<int>(solved.grids.size());
            solved.grids.push_back(put_on_grid(scene, static_cast<int>(i), wanted[i], coarseness, solved));
            if (!solved.grids.back().input.space.failure.empty())
                solved.failure = "part " + scene.parts[i].name + ": " + solved.grids.back().input.space.failure;
        }
    }
    if (!solved.failure.empty()) return solved;
    {
        const Timed timed(seconds, "assembly");
        make_interfaces(scene, candidates, solved);
        note_contact_elements(solved);
        const double before = timed.seconds();
        make_systems(scene, conditions, threads, solved);
        seconds["factorisation"] += factorisation_seconds(solved, timed.seconds() - before);
        if (!solved.failure.empty()) return solved;
    }
    solve_contacts(solved, seconds, threads);
    return solved;
}

void solve_contacts_again(const Scene& scene, const std::vector<Candidate>& candidates, SolvedAssembly& solved,
                          Stopwatches& seconds, int threads) {
    {
        const Timed timed(seconds, "assembly");
        solved.contacts.clear();
        solved.interface_of.clear();
        solved.shear_of.clear();
        solved.problem.interfaces.clear();
        solved.problem.foundation.clear();
        solved.problem.own_normals.clear();
        make_interfaces(scene, candidates, solved);
    }
    solve_contacts(solved, seconds, threads);
}

double largest_condition(const SolvedAssembly& solved) {
    double largest = 0;
    for (const solver::PartSystem& system : solved.problem.parts)
        if (system.failure.empty()) largest = std::max(largest, system.factor.condition_estimate());
    return largest;
}

const Eigen::VectorXd& pressure_of(const SolvedAssembly& solved, std::size_t contact) {
    return solved.solution.pressure[at(solved.interface_of[contact])];
}

}  // namespace abut
