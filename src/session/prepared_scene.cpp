// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/session/prepared_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/linear_algebra/blas_threads.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "solver/terms/solution_structure.hpp"
#include "src/analysis/analyzed.hpp"
#include "src/analysis/stress_error.hpp"
#include "src/answers/field_results.hpp"
#include "src/answers/motion_text.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/discretization/load_vector.hpp"
#include "src/io/number_text.hpp"
#include "src/motion/settle.hpp"
#include "src/scene/load_cases.hpp"
#include "src/session/contact_reader.hpp"

namespace abut {

namespace {

/// The scene with some of its loads, and what these act on.
struct SomeLoads {
    Scene scene;
    ResolvedConditions conditions;
};

/// all: has the loads as they are given; at_rest: has the parts where they are.
template <class Takes>
SomeLoads with_loads(const Scene& all, const ResolvedConditions& conditions, const Scene& at_rest, const Takes& takes) {
    SomeLoads some{at_rest, {conditions.supports, {}}};
    some.scene.loads.clear();
    for (std::size_t i = 0; i < all.loads.size(); ++i) {
        if (!takes(all.loads[i])) continue;
        some.scene.loads.push_back(all.loads[i]);
        some.conditions.loads.push_back(conditions.loads[i]);
    }
    return some;
}

/// Is it prepared, not varied: without a name, or of the same name as a temperature or a preload, which are in a part's own
/// equations?
bool is_fixed(const Scene& scene, const std::string& name) {
    return name.empty() || std::any_of(scene.loads.begin(), scene.loads.end(), [&](const Load& load) {
               return load.name == name && (load.kind == Load::Kind::temperature || load.kind == Load::Kind::preload);
           });
}

/// The weights (2n) of the displacement's component `axis` (assembly axes) at a point, and what it is where they are times
/// zero.
struct PointMeasure {
    Eigen::VectorXd weight;
    double constant = 0;
};
PointMeasure displacement_measure(const PartOnGrid& g, const Vec2& x, int axis) {
    const Vec2 local = g.frame.to_local(x), along = g.frame.vector_to_local(Vec2::Unit(axis));
    const int element = element_at(g.local, g.cells, g.elements, local);
    PointMeasure measure{Eigen::VectorXd::Zero(2 * g.input.space.n_functions)};
    Eigen::VectorXd unit = measure.weight;
    const auto value = [&] { return along.dot(solver::displacement_at(g.input, unit, element, local).value); };
    measure.constant = value();
    for (int f : solver::evaluate(g.input.space, element, local).functions)
        for (Eigen::Index i : {Eigen::Index{2 * f}, Eigen::Index{2 * f + 1}}) {
            unit[i] = 1;
            measure.weight[i] = value() - measure.constant;
            unit[i] = 0;
        }
    return measure;
}

}  // namespace

LoadFactors factors_of_loads(const Scene& scene) {
    LoadFactors factors;
    for (const Load& load : scene.loads)
        if (!load.name.empty()) factors[load.name] = 1;
    return factors;
}

struct PreparedScene::State {
    LoadFactors factors;
    Scene scene;  // under these; `analyzed` refers to it
    Analyzed analyzed;
    int threads = 1;
    std::vector<std::string> names{};                              // of the loads that can be varied
    std::map<std::string, std::vector<std::string>> idle_parts{};  // not computed, by the name of loads that act there
    std::vector<double> scales{};                                  // of the loads
    double own_scale = 0;                                          // of what always acts
    std::vector<ContactReader> readers{};
    std::vector<std::size_t> probes{};  // of the scene: those of parts that are computed
    std::vector<double> probe_constants{};
    std::unique_ptr<solver::LoadAnswers> answers{};
    std::vector<bool> was_open{};
    std::vector<std::string> rigid_pairs{};  // doubts of them
    double allowed_error = 0;                // at free ends of contact
    Eigen::VectorXd last_factors{};
    solver::LoadAnswer last{};

    const Scene& at_rest() const { return analyzed.rest ? analyzed.rest->scene : scene; }
    SolvedAssembly& solved() { return analyzed.outcome.solved; }
    const SolvedAssembly& solved() const { return analyzed.outcome.solved; }
    bool is_answered() const { return analyzed.result.status == "ok"; }

    void prepare(const Scene& drawn);
    solver::UnitLoad unit_load(const SomeLoads& loads) const;
    std::vector<solver::DisplacementMeasure> measures();
    void refer_to_prepared(const Answer& answer);
    void tell_doubts(const std::vector<ReadContact>& contacts, double strongest, Answer& answer) const;
    void tell_motions(Answer& answer) const;
    bool has_friction() const {
        const std::vector<solver::Interface>& faces = solved().problem.interfaces;
        return std::any_of(faces.begin(), faces.end(), [](const solver::Interface& face) { return face.friction.has_value(); });
    }
    bool is_rigid(int part) const {
        const int grid = solved().solver_part[at(part)];
        return grid >= 0 && solved().grids[at(grid)].is_rigid;
    }
    std::string name_of(const ContactAnswer& contact) const { return contact.between[0] + " - " + contact.between[1]; }
};

solver::UnitLoad PreparedScene::State::unit_load(const SomeLoads& loads) const {
    solver::UnitLoad unit;
    for (const PartOnGrid& g : solved().grids) {
        PartLoad load = load_vector(loads.scene, loads.conditions, g);
        unit.scale = std::max(unit.scale, load.scale);
        unit.on_part.push_back(load.scale == 0 ? Eigen::VectorXd() : g.input.structure ? load.weighted : load.vector);
    }
    return unit;
}

/// Of the probes: two numbers each.
std::vector<solver::DisplacementMeasure> PreparedScene::State::measures() {
    std::vector<solver::DisplacementMeasure> all;
    const std::vector<Probe>& asked = at_rest().output.probes;
    for (std::size_t k = 0; k < asked.size(); ++k)
        for (std::size_t i = 0; i < solved().grids.size(); ++i) {
            const PartOnGrid& g = solved().grids[i];
            if (scene_part(at_rest(), g.part).name != asked[k].part) continue;
            probes.push_back(k);
            for (int axis = 0; axis < 2; ++axis) {
                PointMeasure measure = displacement_measure(g, asked[k].at, axis);
                all.emplace_back(solved().grids.size());
                all.back()[i] = std::move(measure.weight);
                probe_constants.push_back(measure.constant);
            }
        }
    return all;
}

/// drawn: with all loads as they are given.
void PreparedScene::State::prepare(const Scene& drawn) {
    const ResolvedConditions conditions = resolve_conditions(drawn);
    // what always acts stays in the parts' own loads
    const Scene under_factors = scene_of_case(drawn, {"", factors, ""});
    const ResolvedConditions under = resolve_conditions(under_factors);
    const auto at_their_place = [&](const Scene& with_their_loads, const ResolvedConditions& on) {
        return analyzed.rest ? placed(with_their_loads, on, analyzed.rest->placements) : with_their_loads;
    };
    const Scene always_loaded = at_their_place(under_factors, under), loaded = at_their_place(drawn, conditions);
    const SomeLoads own =
        with_loads(always_loaded, under, at_rest(), [&](const Load& load) { return is_fixed(drawn, load.name); });
    solver::UnitLoad always = unit_load(own);
    own_scale = always.scale;
    for (const PreloadState& cut : solved().preloads) own_scale = std::max(own_scale, cut.force);
    solved().problem.load_scale = own_scale;
    for (std::size_t i = 0; i < always.on_part.size(); ++i) {
        solver::PartSystem& part = solved().problem.parts[i];
        part.load = part.held_load;
        if (always.on_part[i].size() > 0) part.load += always.on_part[i];
    }
    std::vector<solver::UnitLoad> units;
    for (const auto& [name, factor] : factors) {
        if (is_fixed(drawn, name)) continue;
        names.push_back(name);
        const SomeLoads loads = with_loads(loaded, conditions, at_rest(),
                                           [&, &own_name = name](const Load& load) { return load.name == own_name; });
        units.push_back(unit_load(loads));
        scales.push_back(units.back().scale);
        SomeLoads nothing_else = loads;
        nothing_else.scene.supports.clear();
        nothing_else.conditions.supports.clear();
        for (std::size_t i = 0; i < scene.parts.size(); ++i)
            if (solved().solver_part[i] < 0 && is_driven(nothing_else.scene, nothing_else.conditions, static_cast<int>(i)))
                idle_parts[name].push_back(scene.parts[i].name);
    }
    for (const Candidate& c : analyzed.outcome.candidates)
        if (is_rigid(c.first) && is_rigid(c.second))
            rigid_pairs.push_back("whether parts " + scene_part(scene, c.first).name + " and " +
                                  scene_part(scene, c.second).name +
                                  ", which are both rigid, press on each other is not looked at");
    for (std::size_t k = 0; k < solved().contacts.size(); ++k)
        readers.emplace_back(at_rest(), solved(), k, analyzed.result.contacts[k]);
    answers = std::make_unique<solver::LoadAnswers>(solved().problem, std::move(units), measures(), threads);
}

/// What is open, and how well ends are known, as prepared.
void PreparedScene::State::refer_to_prepared(const Answer& answer) {
    allowed_error = analyzed.outcome.target;
    for (const ContactAnswer& c : answer.contacts) {
        was_open.push_back(c.status == "open");
        allowed_error = std::max(allowed_error, c.error_at_ends);
    }
}

void PreparedScene::State::tell_doubts(const std::vector<ReadContact>& contacts, double strongest, Answer& answer) const {
    constexpr double noted_share = 1e-3;  // of the strongest contact's pressure: less is not worth a word
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const std::string name = name_of(answer.contacts[k]);
        const bool is_open = answer.contacts[k].status == "open" || contacts[k].norm <= noted_share * strongest;
        if (!was_open.empty() && was_open[k] && !is_open)
            answer.doubts.push_back("contact " + name + " was open when its grids were made");
        if (!was_open.empty() && answer.contacts[k].error_at_ends > allowed_error)
            answer.doubts.push_back("contact " + name + " ends where its grids are coarse: there its pressure is known to " +
                                    number_text(100 * answer.contacts[k].error_at_ends, 2) + " % only");
        if (contacts[k].leaves_search && !is_open)
            answer.doubts.push_back("contact " + name + " reaches the end of what was searched");
    }
}

/// Free parts that go far from where their contacts were searched.
void PreparedScene::State::tell_motions(Answer& answer) const {
    for (const solver::PartMotion& m : solver::part_motions(solved().problem.parts, last.amplitudes)) {
        const PartOnGrid& g = solved().grids[at(m.part)];
        const double far = std::max(m.motion.at(g.center).norm(), 0.5 * g.size * std::abs(m.motion.rotation));
        if (far > placed_fraction * g.size)
            answer.doubts.push_back("part " + scene_part(scene, g.part).name + " moves by " + number_text(far, 3) +
                                    " from where its contacts were searched");
    }
}

PreparedScene::PreparedScene(const Scene& scene, const LoadFactors& factors, const AnalyzeOptions& options)
    : state_(std::make_unique<State>()) {
    State& s = *state_;
    s.factors = factors;
    s.threads = solver::usable_threads(options.threads);
    s.scene = scene_of_case(scene, {"", factors, ""});
    s.scene.loads_of_all_cases = scene.loads;
    s.analyzed = analyze_and_keep(s.scene, options);
    if (!s.is_answered()) return;
    s.prepare(scene);
    s.refer_to_prepared(answer(factors));
}

PreparedScene::PreparedScene(PreparedScene&&) noexcept = default;
PreparedScene& PreparedScene::operator=(PreparedScene&&) noexcept = default;
PreparedScene::~PreparedScene() = default;

const LoadFactors& PreparedScene::factors() const {
    return state_->factors;
}

const Result& PreparedScene::result() const {
    return state_->analyzed.result;
}

std::string PreparedScene::needs_preparing(const LoadFactors& factors) const {
    const State& s = *state_;
    for (const auto& [name, factor] : factors) {
        const bool varies = std::find(s.names.begin(), s.names.end(), name) != s.names.end();
        if (factor == s.factors.at(name)) continue;
        if (!s.is_answered()) return "the loads that it was prepared under have no answer";
        if (!varies) return "the temperature or preload '" + name + "' has another factor";
        if (const auto idle = s.idle_parts.find(name); idle != s.idle_parts.end())
            return "the load '" + name + "' acts on part " + idle->second.front() + ", which nothing acted on before";
    }
    return "";
}

Answer PreparedScene::answer(const LoadFactors& factors) {
    State& s = *state_;
    Answer answer;
    if (!s.is_answered()) {
        answer.status = "failed";
        answer.message = result().message;
        return answer;
    }
    s.last_factors.resize(static_cast<Eigen::Index>(s.names.size()));
    double load_scale = s.own_scale;
    for (std::size_t k = 0; k < s.names.size(); ++k) {
        const double factor = factors.at(s.names[k]);
        s.last_factors[static_cast<Eigen::Index>(k)] = factor;
        load_scale = std::max(load_scale, std::abs(factor) * s.scales[k]);
    }
    s.last = s.answers->answer(s.last_factors);
    if (!s.last.mechanism.empty() || !s.last.converged) {
        answer.status = "failed";
        answer.driven = twists_of(s.solved(), s.last.mechanism);
        answer.message = s.last.mechanism.empty() ? "the contact iterations did not converge"
                                                  : "the loads move a part that nothing holds: " +
                                                        motions_text(s.scene, s.solved(), s.last.mechanism);
        return answer;
    }
    std::vector<ReadContact> contacts;
    double strongest = 0;
    for (const ContactReader& reader : s.readers) {
        contacts.push_back(reader.read(s.last, load_scale));
        strongest = std::max(strongest, contacts.back().norm);
    }
    for (ReadContact& c : contacts) {
        c.answer.error_at_ends = strongest > 0 ? c.end_error / strongest : 0;
        answer.contacts.push_back(std::move(c.answer));
    }
    for (const Probe& probe : s.at_rest().output.probes) answer.probes.push_back({probe.part, probe.at, {0, 0}});
    for (std::size_t k = 0; k < s.probes.size(); ++k)
        for (int axis = 0; axis < 2; ++axis) {
            const std::size_t i = 2 * k + at(axis);
            answer.probes[s.probes[k]].displacement[axis] =
                s.last.measured[static_cast<Eigen::Index>(i)] + s.probe_constants[i];
        }
    s.tell_doubts(contacts, strongest, answer);
    answer.doubts.insert(answer.doubts.end(), s.rigid_pairs.begin(), s.rigid_pairs.end());
    if (s.has_friction() && factors != s.factors)
        answer.doubts.push_back(
            "with friction, grids are fine where faces began to slip under the loads prepared: beside other such places shear, "
            "and "
            "what moves by slip, are coarse");
    s.tell_motions(answer);
    return answer;
}

std::vector<PartField> PreparedScene::fields() const {
    State& s = *state_;
    ENSURE(s.last.converged && s.last.mechanism.empty(), "fields are of an answer");
    s.solved().solution.displacement = s.answers->displacements(s.last_factors, s.last, s.threads);
    const std::vector<solver::StressField> stress = stress_fields(s.solved(), s.threads);
    geometry::Box2 model;
    std::size_t cells = 0;
    for (const PartOnGrid& g : s.solved().grids) {
        model.extend(bounding_box(part_of(s.at_rest(), g.part)));
        cells += g.cells.cell_class.size();
    }
    std::vector<PartField> fields(s.scene.parts.size());
    solver::parallel_for(static_cast<int>(stress.size()), s.threads, [&](int k) {
        const PartOnGrid& g = s.solved().grids[at(k)];
        if (stress[at(k)].failure.empty())
            fields[at(g.part)] =
                part_field(g, s.solved().solution.displacement[at(k)], stress[at(k)], drawn_patch * model.diagonal(), cells);
    });
    return fields;
}

}  // namespace abut
