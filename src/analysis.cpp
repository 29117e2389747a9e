// SPDX-License-Identifier: GPL-3.0-or-later
// The walk: conditions -> candidates -> passes (grids, solution, new grids from the contacts found) -> results.
#include "src/analysis.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "src/assembly_model.hpp"
#include "src/contact_results.hpp"
#include "src/cut_quality.hpp"
#include "src/equilibrium.hpp"
#include "src/field_results.hpp"
#include "src/motion_text.hpp"
#include "src/plan.hpp"
#include "src/svg.hpp"

namespace abut {

namespace {

constexpr int max_search_widenings = 5;
constexpr double search_widening = 3;
/// Contacts whose ends move by less than this fraction of their length from one grid to the next are found.
constexpr double settled_fraction = 0.015;
/// The same of the root mean square of its pressure.
constexpr double settled_pressure = 0.05;
/// Rotations and strains beyond which linear kinematics and elasticity are in doubt: a warning.
/// Contact forces that do not balance by more than this fraction are no answer; below, a warning.
constexpr double tolerated_work = 0.02;
constexpr double large_rotation = 0.05, large_strain = 0.05;
constexpr double large_motion = 0.05;  // of the part's size

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

int max_passes(const Scene& scene) {
    if (scene.accuracy.level == "draft") return 3;
    return scene.accuracy.level == "fine" ? 7 : 6;
}

/// Are all grids given, so that there is nothing to adapt?
bool grids_are_fixed(const Scene& scene) {
    if (scene.accuracy.adapt) return !*scene.accuracy.adapt;
    return scene.accuracy.cell_size || !scene.accuracy.grids.empty();
}

struct Outcome {
    std::vector<Candidate> candidates;
    SolvedAssembly solved;
    int passes = 0, factorizations = 0, iterations = 0;
    bool have_previous = false, settled = true, search_too_short = false;
    std::vector<double> previous_peak;  // by candidate
    double previous_energy = 0;
};

double energy_of(const SolvedAssembly& s) {
    double sum = 0;
    for (std::size_t i = 0; i < s.problem.parts.size(); ++i)
        sum += strain_energy(s.problem.parts[i], s.solution.displacement[i]);
    return sum;
}

double peak_of(const SolvedAssembly& s, std::size_t contact) {
    if (s.interface_of[contact] < 0) return 0;
    const solver::KnotVector& k = s.contacts[contact].face.pressure;
    double peak = 0;
    for (int i = 0; i < k.n_intervals(); ++i)
        for (int q = 0; q < 4; ++q) {
            const double a = k.breakpoints[at(i)], b = k.breakpoints[at(i) + 1];
            peak = std::max(peak, solver::pressure_at(k, pressure_of(s, contact), a + (b - a) * q / 3));
        }
    return peak;
}

/// Is the largest pressure that at an end of the interface?
bool peak_at_end(const SolvedAssembly& s, std::size_t contact) {
    if (s.interface_of[contact] < 0) return false;
    const solver::KnotVector& k = s.contacts[contact].face.pressure;
    const double ends = std::max(solver::pressure_at(k, pressure_of(s, contact), k.breakpoints.front()),
                                 solver::pressure_at(k, pressure_of(s, contact), k.breakpoints.back()));
    return ends >= peak_of(s, contact);
}

/// Root of the mean square of a contact's pressure: steady where the peak at a corner has no limit.
double mean_of(const SolvedAssembly& s, std::size_t contact) {
    if (s.interface_of[contact] < 0) return 0;
    double sum = 0, length = 0;
    for (const solver::InterfacePoint& p : s.contacts[contact].face.points) {
        sum += p.weight * std::pow(solver::pressure_at(s.contacts[contact].face.pressure, pressure_of(s, contact), p.s), 2);
        length += p.weight;
    }
    return std::sqrt(sum / length);
}

/// Has contact reached an end of a candidate zone that could be longer?
bool zone_too_short(const SolvedAssembly& s) {
    for (std::size_t k = 0; k < s.contacts.size(); ++k)
        for (const ContactRun& run : s.runs[k])
            if ((run.from_start && s.contacts[k].zone.begin_is_limit) || (run.to_end && s.contacts[k].zone.end_is_limit))
                return true;
    return false;
}

/// How far the search must reach, as a factor on the first search distance, for every pair that the displacements could close.
double needed_search_factor(const Scene& scene, const SolvedAssembly& s) {
    std::vector<double> reach(scene.parts.size(), 0.0);
    for (std::size_t k = 0; k < s.grids.size(); ++k) {
        const double largest = solver::largest_displacement(s.grids[k].input, s.solution.displacement[k]);
        reach[at(s.grids[k].part)] = std::max(reach[at(s.grids[k].part)], largest);
    }
    double factor = 0;
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        for (std::size_t j = i + 1; j < scene.parts.size(); ++j) {
            const auto a = bounding_box(scene.parts[i].part), b = bounding_box(scene.parts[j].part);
            const double closing = reach[i] + reach[j];
            if (a.overlaps(b, closing))
                factor = std::max(factor, closing / (first_search_fraction * std::min(a.diagonal(), b.diagonal())));
        }
    return factor;
}

/// Same contacts as on the grid before, with ends that moved little?
bool same_contacts(const SolvedAssembly& now, const SolvedAssembly& before) {
    if (now.runs.size() != before.runs.size()) return false;
    for (std::size_t k = 0; k < now.runs.size(); ++k) {
        if (now.runs[k].size() != before.runs[k].size()) return false;
        const double a_mean = mean_of(now, k), b_mean = mean_of(before, k);
        if (std::abs(a_mean - b_mean) > settled_pressure * std::max(a_mean, b_mean)) return false;
        // the peak, too, unless it stands at an edge, where it may have no limit
        const double a_peak = peak_of(now, k), b_peak = peak_of(before, k);
        if (std::abs(a_peak - b_peak) > settled_pressure * std::max(a_peak, b_peak) && !peak_at_end(now, k)) return false;
        for (std::size_t r = 0; r < now.runs[k].size(); ++r) {
            const ContactRun &a = now.runs[k][r], &b = before.runs[k][r];
            const double limit = settled_fraction * std::max(a.end - a.begin, b.end - b.begin);
            if (std::abs(a.begin - b.begin) > limit || std::abs(a.end - b.end) > limit) return false;
        }
    }
    return true;
}

/// A zone all the way round starts where the gap is largest; where contact reaches that seam all the same (a pin drawn in the
/// middle of its hole), the seam moves to the middle of the longest open stretch.
void move_seams(const Scene& scene, const SolvedAssembly& s, std::vector<Candidate>& candidates) {
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const std::vector<ContactRun>& runs = s.runs[k];
        geometry::FacingZone& zone = candidates[k].zone;
        if (!zone.closed || runs.empty() || (!runs.front().from_start && !runs.back().to_end)) continue;
        double middle = 0, longest = 0;
        for (std::size_t r = 0; r + 1 < runs.size(); ++r)
            if (const double open = runs[r + 1].begin - runs[r].end; open > longest) {
                longest = open;
                middle = 0.5 * (runs[r].end + runs[r + 1].begin);
            }
        const double total = s.contacts[k].s.back();
        if (const double open = total - runs.back().end; !runs.back().to_end && open > longest) {
            longest = open;
            middle = 0.5 * (total + runs.back().end);
        }
        if (runs.front().begin > longest) {
            longest = runs.front().begin;
            middle = 0.5 * runs.front().begin;
        }
        if (longest == 0) continue;  // pressed all round
        const geometry::FacingPair pair = pair_at(scene, s.contacts[k], middle);
        if (!pair.found) continue;
        zone.begin1 = pair.s1;
        zone.end1 = pair.s1 + zone.chain1.length;
        zone.begin2 = pair.s2;
        zone.end2 = pair.s2 - zone.chain2.length;
    }
}

bool any_run(const SolvedAssembly& s) {
    return std::any_of(s.runs.begin(), s.runs.end(), [](const auto& r) { return !r.empty(); });
}

std::vector<std::pair<int, int>> touching_pairs(const std::vector<Candidate>& candidates) {
    std::vector<std::pair<int, int>> pairs;
    for (const Candidate& c : candidates) pairs.emplace_back(c.first, c.second);
    return pairs;
}

/// Grids, solution, new grids from the contacts found, until these stay where they are.
Outcome solve_adaptively(const Scene& scene, const ResolvedConditions& conditions, const AnalyzeOptions& options,
                         Stopwatches& seconds) {
    Outcome out;
    const double coarseness = coarseness_of(scene);
    double factor = 1;
    const auto search = [&] {
        const auto begin = std::chrono::steady_clock::now();
        out.candidates = find_candidates(scene, factor);
        seconds["geometry"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    search();
    WantedSizes wanted = first_sizes(scene, out.candidates, coarseness);
    int widenings = 0;
    for (;;) {
        if (options.progress) options.progress("pass " + std::to_string(out.passes + 1));
        const std::vector<bool> solve = parts_to_solve(scene, conditions, touching_pairs(out.candidates));
        SolvedAssembly now = solve_pass(scene, conditions, out.candidates, solve, wanted, coarseness, seconds);
        ++out.passes;
        out.factorizations += static_cast<int>(now.problem.parts.size());
        out.iterations += now.solution.iterations;
        const bool stuck = !now.failure.empty() || !now.solution.mechanism.empty();
        const bool may_widen = !scene.contacts.search_distance && widenings < max_search_widenings && scene.contacts.detect &&
                               scene.parts.size() > 1;
        const double needed = stuck ? 0.0 : needed_search_factor(scene, now);
        if (now.failure.empty() && may_widen && (!now.solution.mechanism.empty() || zone_too_short(now) || needed > factor)) {
            ++widenings;
            factor = std::max(search_widening * factor, needed);
            const std::size_t before = out.candidates.size();
            search();
            // nothing more to rest on: look farther before anything is solved again
            for (; stuck && out.candidates.size() == before && widenings < max_search_widenings; ++widenings) {
                factor *= search_widening;
                search();
            }
            out.have_previous = false;
            if (stuck || !any_run(now))
                wanted = first_sizes(scene, out.candidates, coarseness);
            else
                wanted = sizes_from(scene, now, coarseness);
            continue;
        }
        out.search_too_short = !stuck && scene.parts.size() > 1 && scene.contacts.detect &&
                               (zone_too_short(now) || (!scene.contacts.search_distance && needed > factor));
        if (stuck || grids_are_fixed(scene) || !any_run(now)) {
            out.solved = std::move(now);
            return out;
        }
        const bool settled = out.have_previous && same_contacts(now, out.solved);
        if (settled || out.passes >= max_passes(scene) + widenings) {
            out.settled = settled;
            out.solved = std::move(now);
            return out;
        }
        wanted = sizes_from(scene, now, coarseness);
        move_seams(scene, now, out.candidates);
        out.have_previous = true;
        out.previous_energy = energy_of(now);
        out.previous_peak.clear();
        for (std::size_t k = 0; k < now.contacts.size(); ++k) out.previous_peak.push_back(peak_of(now, k));
        out.solved = std::move(now);
    }
}

void fill_parts(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        PartResult part;
        part.name = scene.parts[i].name;
        part.material = scene.materials[at(scene.parts[i].material)].name;
        part.area = area(scene.parts[i].part);
        part.solved = !solved.solver_part.empty() && solved.solver_part[i] >= 0;
        if (part.solved) {
            const PartOnGrid& g = solved.grids[at(solved.solver_part[i])];
            part.unknowns = 2 * g.input.space.n_functions;
            part.grid_angle = std::atan2(g.frame.s, g.frame.c);
            for (double v : g.cells.grid.x) part.grid_x.push_back(v + g.frame.shift.x());
            for (double v : g.cells.grid.y) part.grid_y.push_back(v + g.frame.shift.y());
            for (geometry::CellClass c : g.cells.cell_class) {
                if (c == geometry::CellClass::inner)
                    ++part.cells_inner;
                else if (c == geometry::CellClass::boundary)
                    ++part.cells_boundary;
                else
                    ++part.cells_outer;
            }
            part.quality = cut_quality(g);
            result.unknowns += part.unknowns;
            result.cells[0] += part.cells_inner;
            result.cells[1] += part.cells_boundary;
            result.cells[2] += part.cells_outer;
        }
        result.parts.push_back(std::move(part));
        result.geometry.push_back(scene.parts[i].part);
        result.fields.emplace_back();
    }
}

void fill_probes(const Scene& scene, const SolvedAssembly& solved, const std::vector<solver::StressField>& stress,
                 Result& result) {
    for (const Probe& probe : scene.output.probes)
        for (std::size_t i = 0; i < scene.parts.size(); ++i) {
            if (scene.parts[i].name != probe.part) continue;
            if (solved.solver_part[i] < 0) {  // carries nothing: it stays where it is, without stress
                result.probes.push_back({probe.part, probe.at, {0, 0}, {}});
                result.warnings.push_back("the probe in part " + probe.part + " is zero: nothing acts on that part");
                continue;
            }
            const auto k = at(solved.solver_part[i]);
            const PartOnGrid& g = solved.grids[k];
            const Vec2 local = g.frame.to_local(probe.at);
            const int element = element_at(g.local, g.cells, g.elements, local);
            const FieldSample s = sample_field(g, solved.solution.displacement[k], stress[k], element, local);
            result.probes.push_back({probe.part, probe.at, s.displacement, s.stress});
        }
}

void check_probes(const Scene& scene) {
    std::vector<Problem> problems;
    for (const Probe& probe : scene.output.probes)
        for (const ScenePart& part : scene.parts) {
            if (part.name != probe.part) continue;
            double away = std::numeric_limits<double>::infinity();
            for (const geometry::Edge& e : part.part.edges)
                away = std::min(away, (point(e.curve, closest_parameter(e.curve, probe.at)) - probe.at).norm());
            const double merge = geometry::merge_length(part.part);
            if (away > merge && !contains(part.part, probe.at))
                problems.push_back({probe.where,
                                    "the probe at (" + number_text(probe.at.x(), 6) + ", " + number_text(probe.at.y(), 6) +
                                        ") lies outside part " + probe.part,
                                    "it is " + number_text(away, 3) + " away from the part's boundary"});
        }
    if (!problems.empty()) throw InputError(problems);
}

void fill_errors(const Outcome& out, Result& result) {
    if (!out.have_previous) {
        result.error_estimate.method = "none: one grid only";
        return;
    }
    result.error_estimate.method = "change between the last two grids";
    if (result.strain_energy > 0)
        result.error_estimate.energy = std::abs(result.strain_energy - out.previous_energy) / result.strain_energy;
    constexpr double doubtful = 0.1;
    double worst = 0, largest = 0;
    for (const ContactResult& c : result.contacts) largest = std::max(largest, c.max_pressure.value);
    for (std::size_t k = 0; k < result.contacts.size() && k < out.previous_peak.size(); ++k) {
        if (result.contacts[k].max_pressure.value <= 0) continue;
        const double change = std::abs(result.contacts[k].max_pressure.value - out.previous_peak[k]);
        result.contacts[k].error_estimate = change / result.contacts[k].max_pressure.value;
        worst = std::max(worst, change / largest);
        if (*result.contacts[k].error_estimate > doubtful)
            result.warnings.push_back("the largest pressure of contact " + std::to_string(k) + " changed by " +
                                      number_text(100 * *result.contacts[k].error_estimate, 2) +
                                      " % from the grid before: it has no limit at a sharp corner, or the grid is too coarse");
    }
    if (largest > 0) result.error_estimate.contact_pressure = worst;
}

/// Warnings where the answer does not bear out what was assumed.
void check_assumptions(const Scene& scene, const Outcome& out, Result& result) {
    for (std::size_t k = 0; k < out.solved.grids.size(); ++k) {
        double rotation = 0, strain = 0;
        const PartOnGrid& g = out.solved.grids[k];
        const auto look = [&](int cell, const Vec2& x) {
            const auto u = solver::displacement_at(g.input, out.solved.solution.displacement[k], cell, x);
            rotation = std::max(rotation, 0.5 * std::abs(u.gradient(1, 0) - u.gradient(0, 1)));
            strain = std::max(strain, (0.5 * (u.gradient + u.gradient.transpose())).norm());
        };
        for (const auto& [cell, x] : cut_cell_samples(g)) look(cell, x);
        const std::string& name = scene.parts[at(g.part)].name;
        if (result.parts[at(g.part)].max_displacement.value > large_motion * g.size)
            result.warnings.push_back("large displacement: part " + name + " moves by " +
                                      number_text(result.parts[at(g.part)].max_displacement.value, 3) +
                                      "; contacts are paired where they are drawn");
        if (rotation > large_rotation)
            result.warnings.push_back("large displacement: part " + name + " turns by up to " +
                                      number_text(rotation * 180 / M_PI, 3) +
                                      " degrees; the answer is that of small displacements");
        if (strain > large_strain)
            result.warnings.push_back("large strain: part " + name + " strains by up to " + number_text(100 * strain, 3) +
                                      " %; the answer is that of linear elasticity");
    }
    for (std::size_t r = 0; r < scene.contacts.pairs.size(); ++r) {
        const bool used = std::any_of(out.candidates.begin(), out.candidates.end(),
                                      [&](const Candidate& c) { return c.rule == static_cast<int>(r); });
        if (!used && scene.contacts.pairs[r].kind == PairRule::Kind::contact)
            result.warnings.push_back("contacts.pairs " + std::to_string(r) +
                                      " has no effect: these edges face each other nowhere within the search distance");
    }
    if (out.solved.grids.empty()) result.warnings.push_back("nothing acts on any part: there is nothing to solve");
    if (out.search_too_short)
        result.warnings.push_back("contact reaches the end of what was searched; give contacts.search_distance a larger value");
    if (!out.settled)
        result.warnings.push_back("the contacts still moved between the last two grids by more than " +
                                  number_text(100 * settled_fraction, 2) + " % of their length");
    if (out.solved.limited_grids > 0)
        result.warnings.push_back(
            "grids of " + std::to_string(out.solved.limited_grids) +
            " part(s) are coarser than the contacts ask for, to bound the number of cells; \"fine\" allows more");
    if (out.solved.refined_for_walls > 0)
        result.warnings.push_back("grids of " + std::to_string(out.solved.refined_for_walls) +
                                  " part(s) were refined because a wall was thinner than a cell");
}

std::string motions_text(const Scene& scene, const SolvedAssembly& solved, const std::vector<solver::PartMotion>& motions) {
    constexpr std::size_t named = 4;
    std::string text;
    for (std::size_t k = 0; k < std::min(named, motions.size()); ++k)
        text += (text.empty() ? "" : "; ") + motion_text(scene, solved, motions[k]);
    if (motions.size() > named) text += "; and " + std::to_string(motions.size() - named) + " more";
    return text;
}

void fill_failure(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    result.status = "failed";
    result.solver.converged = false;
    if (!solved.failure.empty()) {
        result.message = solved.failure;
        return;
    }
    result.message =
        "the loads move a part that nothing holds: " + motions_text(scene, solved, solved.solution.mechanism) +
        ". Add a support, or a part that it can rest on; contacts.search_distance says how far contacts are looked for";
}

/// In plane strain from this Poisson's ratio on: splines hold few fields without change of area. Measured on the thick ring
/// (E10), eight cells across: from 0.3 to 0.4999 the largest error of displacements grows 36 times for degree 3, 114 times for
/// degree 2, and stresses of degree 2 are 4 % off at 0.49 and as large as themselves at 0.4999.
constexpr double nearly_incompressible = 0.49;

void warn_of_locking(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    if (scene.analysis != Analysis::plane_strain) return;
    for (const PartOnGrid& g : solved.grids) {
        const ScenePart& part = scene.parts[at(g.part)];
        const double nu = scene.materials[at(part.material)].nu;
        if (nu >= nearly_incompressible)
            result.warnings.push_back("part " + part.name + " is nearly incompressible (nu = " + number_text(nu, 6) +
                                      "): its stresses converge slowly; compare with accuracy.degree 4 and smaller cells");
    }
}

void fill_answers(const Scene& scene, const Outcome& out, Stopwatches& seconds, Result& result) {
    const SolvedAssembly& solved = out.solved;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        result.contacts.push_back(contact_result(scene, solved, out.candidates[k], k));
    result.strain_energy = energy_of(solved);
    fill_equilibrium(scene, solved, result);
    fill_errors(out, result);
    const auto begin = std::chrono::steady_clock::now();
    std::vector<solver::StressField> stress;
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        stress.push_back(stress_field(solved.grids[k], solved.solution.displacement[k]));
        const auto i = at(solved.grids[k].part);
        if (!stress.back().failure.empty()) {
            result.status = "failed";
            result.message =
                "part " + scene.parts[i].name + ": " + stress.back().failure +
                "; its cells are too coarse where it is thin: set accuracy.refine there, or a higher accuracy.level";
            return;
        }
        PartFieldResult field = part_field(solved.grids[k], solved.solution.displacement[k], stress.back());
        result.parts[i].max_displacement = field.max_displacement;
        result.parts[i].max_von_mises = field.max_von_mises;
        result.fields[i] = std::move(field.field);
    }
    fill_probes(scene, solved, stress, result);
    seconds["recovery"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::set<std::string> neutral;
    for (const solver::PartMotion& m : solved.solution.neutral) neutral.insert(motion_text(scene, solved, m));
    for (const std::string& text : neutral)
        result.warnings.push_back("nothing holds a motion that no load drives (the answer of least motion is given): " + text);
    check_assumptions(scene, out, result);
    warn_of_locking(scene, solved, result);
}

Result analyze_checked(const Scene& scene, const AnalyzeOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    Stopwatches seconds{{"import", 0}, {"geometry", 0}, {"assembly", 0}, {"solve", 0}, {"recovery", 0}};
    Result result;
    result.title = scene.title;
    result.length_unit = scene.length_unit;
    result.force_unit = scene.force_unit;
    result.degree = scene.accuracy.degree;
    result.effects = plan_effects(scene);
    result.warnings = scene.warnings;
    check_probes(scene);
    const ResolvedConditions conditions = resolve_conditions(scene);
    result.support_marks = support_marks(scene, conditions);
    result.load_marks = load_marks(scene, conditions);

    const Outcome out = solve_adaptively(scene, conditions, options, seconds);
    fill_parts(scene, out.solved, result);
    result.multipliers = out.solved.solution.n_multipliers;
    result.solver = {out.passes, out.factorizations, out.iterations, largest_condition(out.solved),
                     out.solved.solution.converged};
    if (!out.solved.failure.empty() || !out.solved.solution.mechanism.empty()) {
        fill_failure(scene, out.solved, result);
    } else {
        if (!out.solved.solution.converged) {
            result.status = "failed";
            result.message = "the contact iterations did not converge";
        }
        const std::vector<solver::PartMotion>& driven = out.solved.solution.driven;
        if (!driven.empty() && out.solved.solution.driven_work <= tolerated_work)
            result.warnings.push_back("contact pushes with " + number_text(100 * out.solved.solution.driven_work, 2) +
                                      " % of its force along a motion that frictionless contact does not hold (" +
                                      motions_text(scene, out.solved, driven) +
                                      "); hold the part by a support if that matters");
        if (!driven.empty() && out.solved.solution.driven_work > tolerated_work) {
            result.status = "failed";
            result.message =
                "no contact can balance the loads: " + motions_text(scene, out.solved, out.solved.solution.driven) +
                ". Add a support, or a part that it can rest on";
        }
        fill_answers(scene, out, seconds, result);
    }
    for (Effect& e : result.effects)
        if (e.on && e.name == "contact") e.seconds = seconds["solve"];
    const double total = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (const char* stage : {"import", "geometry", "assembly", "solve", "recovery"})
        result.timing.emplace_back(stage, seconds[stage]);
    result.timing.emplace_back("output", 0);
    result.timing.emplace_back("total", total);
    return result;
}

}  // namespace

Result analyze(const Scene& scene, const AnalyzeOptions& options) {
    try {
        return analyze_checked(scene, options);
    } catch (const InputError& error) {
        std::vector<Problem> problems = error.problems();
        for (Problem& p : problems)
            if (p.where.starts_with('/')) p.where = scene.file + " " + p.where;
        throw InputError(std::move(problems));
    }
}

}  // namespace abut
