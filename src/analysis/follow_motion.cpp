// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/follow_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "geometry/brep/part.hpp"
#include "src/analysis/moved_pairs.hpp"
#include "src/analysis/placement.hpp"
#include "src/analysis/turned_contacts.hpp"
#include "src/base/index.hpp"
#include "src/contact/candidates.hpp"
#include "src/io/number_text.hpp"
#include "src/motion/leads.hpp"
#include "src/motion/way_left.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"
#include "src/solution/contact_measures.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

bool has_answer(const Outcome& out) {
    return out.solved.failure.empty() && out.solved.solution.mechanism.empty() && out.solved.solution.converged;
}

/// Solves the scene with its parts placed there. False: it has no answer there either.
bool solve_at(const Scene& drawn, const ResolvedConditions& conditions, Rest there, const AnalyzeOptions& options,
              Stopwatches& seconds, Outcome& out, std::optional<Rest>& rest) {
    // parts that press on each other overlap where their rigid motions have them: contact presses them apart; with friction,
    // which would hold what is pressed together before the loads are, they touch
    if (there.scene.contacts.overlap == "report")
        there.scene.contacts.overlap = has_friction(drawn.contacts) ? "touching" : "press_fit";
    Outcome answer;
    try {
        answer = solve_adaptively(there.scene, conditions, options, seconds);
    } catch (const InputError&) { return false; }  // overlaps of parts that press on each other: no better place
    if (!has_answer(answer)) return false;
    if (!has_fits(drawn.contacts)) answer.uses.erase("interference");  // what bodies are pressed apart by is their own contact
    out = std::move(answer);
    rest = std::move(there);
    return true;
}

/// Is the target missed since pairs were found where the parts were?
bool is_paired_astray(const Scene& scene, const Outcome& out) {
    const std::vector<double> of_pairs = moved_pair_errors(scene, out.solved);
    const std::vector<std::optional<ContactError>>& errors = out.errors.back().contacts;
    for (std::size_t k = 0; k < of_pairs.size(); ++k) {
        const ContactError error = k < errors.size() ? errors[k].value_or(ContactError{}) : ContactError{};
        const double by_pairs = error.share * 2 * of_pairs[k], by_grids = error.share * error.pressure;
        if (std::hypot(by_pairs, by_grids) > out.target && by_pairs > 0.5 * out.target) return true;
    }
    return false;
}

/// Where a solution has all parts: those that are led are there, which is none of their free motions.
std::vector<Placement> motions_of(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved) {
    std::vector<solver::RigidMotion> motions;
    for (const ScenePart& part : scene.parts) motions.push_back({{0, 0}, 0, centroid(part.part)});
    for (std::size_t k = 0; k < solved.grids.size(); ++k) motions[at(solved.grids[k].part)] = rigid_motion_of(solved, k);
    const Leads leads = leads_of(scene, conditions);
    std::vector<Placement> placements;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const Lead& lead = leads.of[i];
        Eigen::Vector3d by = lead.of(motions[i].translation, motions[i].rotation);
        for (std::size_t c = 0; c < lead.is_given.size(); ++c)
            if (lead.is_given[c]) by[static_cast<Eigen::Index>(c)] = lead.to[static_cast<Eigen::Index>(c)];
        placements.push_back(about_center(motions[i].center, lead.translation(by.head<2>()), by[2]));
    }
    return placements;
}

bool goes_nowhere(const std::vector<Placement>& placements) {
    return std::all_of(placements.begin(), placements.end(), [](const Placement& p) { return p.goes_nowhere(); });
}

/// How far a part is at one place from another, turns measured at its half diagonal.
double distance_between(const geometry::Part& part, const Placement& a, const Placement& b) {
    const Vec2 center = centroid(part);
    return std::max((a.of(center) - b.of(center)).norm(), 0.5 * bounding_box(part).diagonal() * std::abs(a.angle - b.angle));
}

/// The largest distance of motions from these placements, of how far the motions go.
double share_not_explained(const Scene& drawn, const std::vector<Placement>& motions,
                           const std::vector<Placement>& placements) {
    double most = 0, left = 0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const geometry::Part& part = drawn.parts[i].part;
        most = std::max(most, distance_between(part, motions[i], {}));
        left = std::max(left, distance_between(part, motions[i], placements[i]));
    }
    return most > 0 ? left / most : 0;
}

/// Do the parts of a solution move as their placements say, but for half of it? What else they move by is elastic, and would
/// have them paired astray from there as well.
bool is_explained_by(const Scene& drawn, const ResolvedConditions& conditions, const std::vector<Placement>& placements,
                     const SolvedAssembly& solved) {
    return share_not_explained(drawn, motions_of(drawn, conditions, solved), placements) <= 0.5;
}

/// Do supports lead a part farther than pairs as drawn are good for?
bool are_led_far(const Scene& drawn, const ResolvedConditions& conditions) {
    const Leads leads = leads_of(drawn, conditions);
    for (std::size_t i = 0; i < drawn.parts.size(); ++i)
        if (is_far(leads.of[i].to.head<2>(), leads.of[i].to[2], bounding_box(drawn.parts[i].part).diagonal())) return true;
    return false;
}

constexpr double noted = 1e-3;  // of a part's size: nearer by, pairs and lines of force are as drawn

/// Do parts that something stops on the way that supports lead them touch others there that they had nothing to do with where
/// they are drawn? A solution from there has them go through these.
bool meet_others(const Scene& drawn, const ResolvedConditions& conditions, const std::vector<Placement>& placements,
                 const std::vector<Candidate>& as_drawn) {
    const Leads leads = leads_of(drawn, conditions);
    const auto is_stopped = [&](int i) {
        const geometry::Part& part = drawn.parts[at(i)].part;
        const Vec2 center = centroid(part);
        const Lead& lead = leads.of[at(i)];
        const double size = bounding_box(part).diagonal();
        Eigen::Vector3d left = lead.to - lead.of(placements[at(i)].of(center) - center, placements[at(i)].angle);
        for (std::size_t k = 0; k < lead.is_given.size(); ++k)
            if (!lead.is_given[k]) left[static_cast<Eigen::Index>(k)] = 0;
        return std::max(left.head<2>().norm(), 0.5 * size * std::abs(left[2])) > noted * size;
    };
    const PartPairs known = touching_pairs(as_drawn);
    const std::vector<Candidate> there = find_candidates_anyway(placed(drawn, conditions, placements), 1);
    return std::any_of(there.begin(), there.end(), [&](const Candidate& c) {
        return (is_stopped(c.first) || is_stopped(c.second)) &&
               std::find(known.begin(), known.end(), std::pair(c.first, c.second)) == known.end();
    });
}

/// Where parts rest without friction, if that is where a solution has them but for what is elastic in it: bodies that just
/// touch, while the solution has them pressed into each other. Where parts are led far, whatever friction does, or pressed on
/// others that springs hold, which give way, the solution tells of them only whether they go along, and nothing where they
/// meet what it does not know of. Nothing where none goes
/// farther than its pairs are good for.
std::optional<Rest> rest_beside(const Scene& drawn, const ResolvedConditions& conditions, const Outcome& out) {
    constexpr double elastic = 0.02;  // of how far they go, which is far beside what they are strained by
    constexpr double along = 0.5;     // likewise
    const std::vector<Placement> motions = motions_of(drawn, conditions, out.solved);
    bool any_goes = false;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const geometry::Part& part = drawn.parts[i].part;
        any_goes = any_goes || distance_between(part, motions[i], {}) > noted * bounding_box(part).diagonal();
    }
    if (!any_goes) return std::nullopt;
    Settling loose = settle(without_friction(drawn), conditions, {}, true);
    if (loose.placements.empty()) return std::nullopt;
    const double most = are_led_far(drawn, conditions) || has_support(drawn, Support::Kind::spring) ? along : elastic;
    if (share_not_explained(drawn, motions, loose.placements) > most &&
        !meet_others(drawn, conditions, loose.placements, out.candidates))
        return std::nullopt;
    return rest_at(drawn, conditions, short_of_rest(drawn, conditions, loose.placements));
}

/// Do all points of the outer boundary lie at one distance from the centroid, so that turning it changes nothing?
bool is_round(const geometry::Part& part) {
    constexpr double round_fraction = 1e-3;
    const Vec2 center = centroid(part);
    double nearest = 0, farthest = 0;
    for (const geometry::Loop& loop : part.loops) {
        double near = std::numeric_limits<double>::infinity(), far = 0;
        for (int e : loop.edges)
            for (double t : {0.0, 0.25, 0.5, 0.75}) {
                const double r = (point(curve_of(part, e), t) - center).norm();
                near = std::min(near, r);
                far = std::max(far, r);
            }
        if (far > farthest) std::tie(nearest, farthest) = std::tuple(near, far);  // the outer loop is the farthest
    }
    return farthest - nearest <= round_fraction * farthest;
}

/// A part that falls over is no longer the assembly that was drawn, however well it is balanced where it comes to lie.
void tell_tipping(const Scene& drawn, const Rest& rest, Result& result) {
    constexpr double tipping = std::numbers::pi / 4;  // from there on another side of a square is nearer to where it was
    if (std::any_of(drawn.supports.begin(), drawn.supports.end(),
                    [](const Support& s) { return s.rigid_rotation.value_or(0) != 0; }))
        return;
    std::vector<Finding> tipped;
    for (std::size_t i = 0; i < drawn.parts.size(); ++i) {
        const double angle = rest.placements[i].angle;
        if (std::abs(angle) < tipping || is_round(drawn.parts[i].part)) continue;
        const std::string turns = drawn.parts[i].name + " turns by " +
                                  number_text(std::abs(angle) * 180 / std::numbers::pi, 3) + " degrees before it rests";
        tipped.push_back(
            {std::abs(angle), drawn.parts[i].name, "a part does not stay on the side it was drawn on: " + turns, turns});
    }
    tell(std::move(tipped), "displacement", result);
}

/// The point of a part that a placement has brought to x.
Vec2 from_where(const Placement& p, const Vec2& x) {
    return Placement{-p.angle, {0, 0}}.turned(x - p.shift);
}

/// Where a part is led, or pushed by one that is, along another for longer than the solution has it slide, friction is at its
/// limit; that of soft bodies may not have come there over what was left of the way.
void tell_friction_short_of_its_limit(const Scene& drawn, const ResolvedConditions& conditions, const Rest& rest,
                                      const SolvedAssembly& solved, Result& result) {
    constexpr double slid = 5e-4;      // of the smaller part's size: half of what is left of the way
    constexpr double slides = 0.1;     // of that: what friction holds lies still if it moves no more, however far it has come
    constexpr double at_limit = 0.98;  // a rim may stick
    if (!solved.problem.before.empty()) return;  // of a later step, in which they are there
    std::vector<Finding> findings;
    const Leads leads = leads_of(drawn, conditions);
    if (std::none_of(leads.of.begin(), leads.of.end(), [](const Lead& lead) { return lead.goes_anywhere(); })) return;
    const std::vector<Placement> motions = motions_of(rest.scene, conditions, solved);
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const double friction = friction_of(solved, k);
        if (friction == 0 || !std::isfinite(friction) || solved.stretches[k].empty()) continue;
        const double share = friction_sums(solved, k).share_of_limit(friction);
        if (share >= at_limit) continue;
        const std::array<int, 2>& part = solved.contacts[k].part;
        const PressedStretch& stretch = solved.stretches[k].front();
        const geometry::FacingPair pair = pair_at(rest.scene, solved.contacts[k], 0.5 * (stretch.begin + stretch.end));
        const Vec2 by =
            from_where(rest.placements[at(part[0])], pair.on1.x) - from_where(rest.placements[at(part[1])], pair.on1.x);
        const double along = std::abs(geometry::left_of(pair.normal).dot(by)),
                     size = std::min(bounding_box(drawn.parts[at(part[0])].part).diagonal(),
                                     bounding_box(drawn.parts[at(part[1])].part).diagonal());
        const Vec2 now = motions[at(part[0])].of(pair.on1.x) - motions[at(part[1])].of(pair.on1.x);
        const bool lies_still = std::abs(geometry::left_of(pair.normal).dot(now)) <= slides * slid * size;
        if (along <= slid * size || (rest.is_held && lies_still)) continue;
        const std::string who = drawn.parts[at(part[0])].name + " and " + drawn.parts[at(part[1])].name;
        findings.push_back({along, who,
                            who + " slide along each other by " + with_unit(along, 3, drawn.length_unit) +
                                ", but over the last of it, which the solution has, friction has come to " +
                                percent_text(share) +
                                " of its limit only: draw them nearer to where they come to rest, or take \"motion\": \"off\"",
                            "friction between " + who + " is not at its limit though they slide"});
    }
    tell(std::move(findings), "displacement", result);
}

/// Do parts turn by more than small displacements are good for?
bool turn_far(const SolvedAssembly& solved) {
    for (std::size_t k = 0; k < solved.grids.size(); ++k)
        if (std::abs(rigid_motion_of(solved, k).rotation) > placed_turn) return true;
    return false;
}

/// Where parts go that friction does not hold, far from where they are drawn; nothing where it does, or none is known.
std::optional<Rest> where_let_go(const Scene& drawn, const ResolvedConditions& conditions, const Outcome& out) {
    const bool is_answer = has_answer(out), goes_on = is_answer && do_parts_go_on(drawn, out.solved),
               are_led = are_led_far(drawn, conditions);
    if (is_answer && !goes_on && !are_led && !far_placements_of(drawn, out.solved)) return std::nullopt;
    Settling there = settle_until_held(drawn, conditions, !is_answer || goes_on || turn_far(out.solved));
    if (there.end == Settling::End::not_asked && (is_answer || out.solved.solution.holding_factor > 0)) return std::nullopt;
    const bool is_held = there.end == Settling::End::rests;
    if (there.end == Settling::End::not_asked || (there.end == Settling::End::lost && are_led && !is_answer))
        there = settle(without_friction(drawn), conditions);
    if (there.end != Settling::End::rests) return std::nullopt;
    return rest_at(drawn, conditions, short_of_rest(drawn, conditions, there.placements), is_held);
}

}  // namespace

std::optional<Rest> rest_of(const Scene& drawn, const ResolvedConditions& conditions, const Settling& settling) {
    if (settling.end != Settling::End::rests) return std::nullopt;
    find_candidates(drawn, 1);  // for overlaps that the scene does not allow: where parts rest some are their own
    return rest_at(drawn, conditions, short_of_rest(drawn, conditions, settling.placements));
}

std::optional<Rest> let_go(const Scene& drawn, const ResolvedConditions& conditions, const Outcome& out) {
    if (!has_friction(drawn.contacts)) return std::nullopt;
    std::optional<Rest> there = where_let_go(drawn, conditions, out);
    return there || !has_answer(out) ? there : rest_beside(drawn, conditions, out);
}

void follow_motion(const Scene& drawn, const ResolvedConditions& conditions, const Settling& settling,
                   const AnalyzeOptions& options, Stopwatches& seconds, Outcome& out, std::optional<Rest>& rest) {
    constexpr int most_placements = 5;
    if (settling.end == Settling::End::stays &&
        (!has_answer(out) || is_paired_astray(drawn, out) || are_forces_turned(drawn, out))) {
        Settling beside = settle(drawn, conditions, settling.placements, true);
        if (!goes_nowhere(beside.placements) &&
            (!has_answer(out) || is_explained_by(drawn, conditions, beside.placements, out.solved)))
            solve_at(drawn, conditions, rest_at(drawn, conditions, short_of_rest(drawn, conditions, beside.placements)),
                     options, seconds, out, rest);
    }
    if (!drawn.in_steps)
        if (std::optional<Rest> there = let_go(drawn, conditions, out))
            solve_at(drawn, conditions, std::move(*there), options, seconds, out, rest);
    // With friction parts would begin anew where they have gone, beside springs that begin where they are drawn.
    const bool begins_anew = has_friction(drawn.contacts) && has_support(drawn, Support::Kind::spring);
    for (int k = 0; k < most_placements && has_answer(out) && !begins_anew; ++k) {
        const std::optional<std::vector<Placement>> more = placements_of(drawn, conditions, out.solved);
        if (!more) break;
        std::vector<Placement> placements = rest ? rest->placements : std::vector<Placement>(drawn.parts.size());
        std::vector<char> slide;
        for (std::size_t i = 0; i < placements.size(); ++i) {
            placements[i] = followed_by(placements[i], (*more)[i]);
            slide.push_back(!(*more)[i].goes_nowhere());
        }
        std::vector<Placement> short_of_there = with_way_left(drawn, conditions, std::move(placements), slide);
        if (!solve_at(drawn, conditions, rest_at(drawn, conditions, std::move(short_of_there)), options, seconds, out, rest))
            break;
    }
}

void tell_motion(const Scene& drawn, const ResolvedConditions& conditions, const std::optional<Rest>& rest,
                 const Settling& settling, Outcome& out, Result& result) {
    if (settling.end == Settling::End::never && has_answer(out))
        out.solved.failure = "the loads move parts that nothing holds: " + settling.why +
                             ". Add a support, or a part that it can rest on, or draw it where it comes to rest";
    if (settling.end == Settling::End::lost && has_answer(out))
        tell({{0, "", "parts move far before they rest, and " + settling.why + ": this is the answer where they are drawn",
               "the parts' place of rest is not known"}},
             "displacement", result);
    if (!settling.unstable.empty())
        result.warnings.push_back(settling.unstable + ": this is the answer as long as nothing does");
    Effect row = large_motion_effect(settling);
    if (rest) {
        Settling there{Settling::End::rests, "", rest->placements, {}, ""};
        std::vector<std::string> far, near;
        for (std::size_t i = 0; i < drawn.parts.size(); ++i) {
            const double size = bounding_box(drawn.parts[i].part).diagonal();
            const Vec2 center = centroid(drawn.parts[i].part);
            const Placement& p = rest->placements[i];
            if (p.goes_nowhere()) continue;
            result.parts[i].placement = {p.of(center) - center, p.angle};
            const bool goes_far = is_far(p.of(center) - center, p.angle, size);
            if (goes_far) there.parts.push_back(drawn.parts[i].name);
            (goes_far ? far : near).push_back(placement_text(drawn.parts[i].name, p, center, size));
        }
        there.why = first_few(far.empty() ? near : far);
        row = large_motion_effect(there);
        result.warnings.push_back(
            "analysed where the loads take it, " + there.why +
            " from where it was drawn: places and displacements are those from there" +
            (has_friction(drawn.contacts) ? ", and friction acts from there on: so count slip and the work against it" : ""));
        tell_tipping(drawn, *rest, result);
        if (has_answer(out)) tell_friction_short_of_its_limit(drawn, conditions, *rest, out.solved, result);
    }
    result.effects.push_back(std::move(row));
}

}  // namespace abut
