// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/assembly_model.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace abut {

namespace {

constexpr int max_wall_refinements = 5;
/// Cells of all parts together, and of one part at least, before wanted sizes are given up; coarsened by this factor at a time.
constexpr double standard_cells = 60000, least_cells_of_part = 3000, budget_coarsening = 1.3;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

class Timed {
public:
    Timed(Stopwatches& seconds, std::string stage) : seconds_(seconds), stage_(std::move(stage)) {}
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;
    ~Timed() { seconds_[stage_] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

private:
    Stopwatches& seconds_;
    std::string stage_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// More cells than this in one part are a slip of the pen, not a wish.
constexpr double most_cells = 4e6;

void refuse_too_many(double columns, double rows, const std::string& where) {
    if (columns * rows > most_cells)
        throw InputError(where, "this asks for a grid of about " + std::to_string(static_cast<long>(columns * rows)) + " cells",
                         "at most " + std::to_string(static_cast<long>(most_cells)) + " are possible for one part");
}

/// Grid lines from the scene's explicit grid, in the part's local frame.
geometry::Grid explicit_grid(const GridOptions& options, const geometry::Part& local, const Frame& frame) {
    refuse_too_many(std::max<double>(options.cells[0], static_cast<double>(options.x.size())),
                    std::max<double>(options.cells[1], static_cast<double>(options.y.size())), options.where);
    geometry::Grid grid{options.x, options.y};
    const geometry::Box2 box = bounding_box(local);
    for (int axis : {0, 1}) {
        std::vector<double>& lines = axis == 0 ? grid.x : grid.y;
        for (double& v : lines) v -= frame.shift[axis];
        if (!lines.empty()) continue;
        // a shifted grid of so many cells over the part needs one more cell to cover it
        const int n = options.cells[static_cast<std::size_t>(axis)];
        const double h = box.size()[axis] / n;
        double begin = std::fmod(options.offset[axis], h);
        if (begin > 0) begin -= h;
        const int cells = begin < 0 ? n + 1 : n;
        for (int k = 0; k <= cells; ++k) lines.push_back(box.min[axis] + begin + k * h);
        if (begin == 0) lines.back() = box.max[axis];
    }
    return grid;
}

std::vector<SizeFeature> local_features(const std::vector<WantedSize>& wanted, const Frame& frame) {
    std::vector<SizeFeature> features;
    for (const WantedSize& w : wanted) {
        SizeFeature f{{}, w.size};
        for (const Vec2& p : w.points) f.box.extend(frame.to_local(p));
        features.push_back(f);
    }
    return features;
}

geometry::Grid designed_grid(const Scene& scene, const geometry::Part& local, const Frame& frame,
                             const std::vector<WantedSize>& wanted, double coarseness, double refinement, double budget,
                             bool& limited) {
    const geometry::Box2 box = bounding_box(local);
    if (scene.accuracy.cell_size)
        refuse_too_many(box.size().x() / *scene.accuracy.cell_size, box.size().y() / *scene.accuracy.cell_size,
                        "/accuracy/cell_size");
    std::array<double, 2> largest = largest_cells(local, coarseness);
    std::vector<SizeFeature> features;
    if (scene.accuracy.cell_size)
        largest = {*scene.accuracy.cell_size, *scene.accuracy.cell_size};
    else
        features = shape_features(local, coarseness);
    if (!scene.accuracy.cell_size || scene.accuracy.adapt.value_or(false)) {
        const auto more = local_features(wanted, frame);
        features.insert(features.end(), more.begin(), more.end());
    }
    for (const Refinement& r : scene.accuracy.refine) {
        geometry::Box2 around;
        around.extend(Vec2(frame.to_local(r.near) - Vec2::Constant(r.radius)));
        around.extend(Vec2(frame.to_local(r.near) + Vec2::Constant(r.radius)));
        features.push_back({around, r.cell_size});
    }
    for (SizeFeature& f : features) f.size *= refinement;
    for (;;) {
        geometry::Grid grid{graded_lines(box.min.x(), box.max.x(), 0, refinement * largest[0], features),
                            graded_lines(box.min.y(), box.max.y(), 1, refinement * largest[1], features)};
        if (static_cast<double>(grid.columns()) * grid.rows() <= budget || scene.accuracy.cell_size) return grid;
        limited = true;
        for (SizeFeature& f : features) f.size *= budget_coarsening;
        for (double& h : largest) h *= std::sqrt(budget_coarsening);
    }
}

PartOnGrid put_on_grid(const Scene& scene, int part, const std::vector<WantedSize>& wanted, double coarseness,
                       SolvedAssembly& solved) {
    const ScenePart& source = scene.parts[at(part)];
    const auto given = scene.accuracy.grids.find(source.name);
    const int degree = scene.accuracy.degree;
    if (given != scene.accuracy.grids.end()) {
        const Frame frame = frame_for(source.part, given->second.angle);
        const geometry::Part local = transformed(source.part, frame.c, -frame.s, -frame.shift);
        return discretize(scene, part, frame, explicit_grid(given->second, local, frame),
                          given->second.degree.value_or(std::array<int, 2>{degree, degree}));
    }
    const Frame frame = frame_for(source.part, 0);
    const geometry::Part local = transformed(source.part, frame.c, -frame.s, -frame.shift);
    const double budget =
        std::max(least_cells_of_part, standard_cells / coarseness / coarseness / static_cast<double>(scene.parts.size()));
    bool limited = false;
    double refinement = 1;
    for (int attempt = 0;; ++attempt, refinement *= 0.5) {
        PartOnGrid g =
            discretize(scene, part, frame, designed_grid(scene, local, frame, wanted, coarseness, refinement, budget, limited),
                       {degree, degree});
        if (g.input.space.failure.empty() || attempt == max_wall_refinements || scene.accuracy.cell_size) {
            if (attempt > 0) ++solved.refined_for_walls;
            if (limited) ++solved.limited_grids;
            return g;
        }
    }
}

solver::PartSystem make_system(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& g,
                               double& load_scale) {
    PartLoad load = load_vector(scene, conditions, g);
    load_scale = std::max(load_scale, load.scale);
    return solver::make_part_system(g.input, support_sets(scene, conditions, g), std::move(load.vector), g.center, g.size);
}

void make_interfaces(const Scene& scene, const std::vector<Candidate>& candidates, SolvedAssembly& solved) {
    for (const Candidate& c : candidates) {
        const int a = solved.solver_part[at(c.first)], b = solved.solver_part[at(c.second)];
        solved.interface_of.push_back(-1);
        solved.contacts.emplace_back();
        solved.contacts.back().part = {c.first, c.second};
        if (a < 0 || b < 0) continue;
        solved.contacts.back() =
            make_interface(scene, c.zone, solved.grids[at(a)], solved.grids[at(b)], {a, b}, c.closing, c.no_overlap);
        ContactInterface& contact = solved.contacts.back();
        if (contact.face.points.empty()) continue;
        solved.interface_of.back() = static_cast<int>(solved.problem.interfaces.size());
        solved.problem.interfaces.push_back(contact.face);
        solved.problem.foundation.push_back(contact.foundation);
        solved.problem.own_normals.push_back(contact.own_normals);
    }
}

}  // namespace

double coarseness_of(const Scene& scene) {
    if (scene.accuracy.level == "draft") return 1.6;
    if (scene.accuracy.level == "fine") return 0.55;
    return 1;
}

SolvedAssembly solve_pass(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                          const std::vector<bool>& solve_part, const WantedSizes& wanted, double coarseness,
                          Stopwatches& seconds) {
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
        for (const PartOnGrid& g : solved.grids) {
            solved.problem.parts.push_back(make_system(scene, conditions, g, solved.problem.load_scale));
            const solver::PartSystem& system = solved.problem.parts.back();
            for (const solver::SupportRecord& record : system.supports)
                if (scene.accuracy.dirichlet == "aligned" && record.method == solver::SupportMethod::nitsche)
                    throw InputError(scene.supports[at(record.set.tag)].where,
                                     "this support cannot be imposed by dropping functions: it does not lie along the "
                                     "outermost grid lines of part " +
                                         scene.parts[at(g.part)].name,
                                     "set accuracy.dirichlet to \"auto\" or \"nitsche\"");
            if (!system.failure.empty())
                solved.failure = "part " + scene.parts[at(g.part)].name + ": " + system.failure;
            else
                solved.condition = std::max(solved.condition, system.factor.condition_estimate());
            for (solver::MeanConstraint& c : mean_constraints(scene, g, static_cast<int>(solved.problem.parts.size()) - 1))
                solved.problem.constraints.push_back(std::move(c));
        }
        if (!solved.failure.empty()) return solved;
        make_interfaces(scene, candidates, solved);
    }
    const Timed timed(seconds, "solve");
    solved.solution = solve_assembly(solved.problem);
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        solved.runs.emplace_back();
        if (solved.interface_of[k] >= 0 && solved.solution.mechanism.empty())
            solved.runs.back() = contact_runs(solved.contacts[k].face.pressure, pressure_of(solved, k));
    }
    return solved;
}

const Eigen::VectorXd& pressure_of(const SolvedAssembly& solved, std::size_t contact) {
    return solved.solution.pressure[at(solved.interface_of[contact])];
}

}  // namespace abut
