// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/accuracy_results.hpp"

#include <algorithm>
#include <cmath>

#include "src/analysis/largest_stress.hpp"
#include "src/analysis/missed_contacts.hpp"
#include "src/analysis/static_forces.hpp"
#include "src/analysis/stress_error.hpp"
#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"
#include "src/scene/accuracy_goal.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

/// The entry of a vector that may be too short.
double at_or_zero(const std::vector<double>& values, std::size_t k) {
    return k < values.size() ? values[k] : 0;
}

/// What a contact's force errs by for other reasons than the grid.
double force_error_of(const ModelErrors& of_model, std::size_t contact) {
    return std::hypot(at_or_zero(of_model.of_turns, contact), at_or_zero(of_model.of_points, contact));
}

/// What a bond bears errs like the stress of its parts (in the energy norm, the worse of both), where statics leaves it open:
/// at its ends the stress has no limit (bimetal strips, clamped: 0.3 to 1.7 of it). 0: it is no bond, or nothing is known.
double bond_error(const Outcome& out, const ErrorEstimate& error, std::size_t contact) {
    if (contact >= out.solved.contacts.size() || !out.solved.contacts[contact].face.bilateral) return 0;
    double missed = 0;
    for (const int part : out.solved.contacts[contact].face.part)
        if (static_cast<std::size_t>(part) < error.own_energy.size())
            missed = std::max(missed, error.own_energy[static_cast<std::size_t>(part)]);
    return std::min(1.0, std::sqrt(missed));
}

/// A force that statics alone give errs by what its change from grid to grid shows, which the energy bounds: a cylinder on a
/// block 2 to 12 times what the change says, 2e-6 of the force. Others err like the energy, in absolute terms of the largest on
/// the same parts, half of it: those that share the loads with much larger ones by more, however little they change (over
/// the true error: vise and the beam's four pins 0.2 to 12).
double force_error(const Outcome& out, const ErrorEstimate& error, const Result& result, std::size_t contact, bool is_static) {
    constexpr double most_missed = 16, shared = 0.5;
    const double change = error.contacts[contact]->force, energy = error.energy.value_or(0);
    if (is_static) return std::clamp(energy, change, most_missed * change);
    const double of_stiffness = std::max(error.contacts[contact]->of_stiffness, bond_error(out, error, contact));
    const ContactResult& own = result.contacts[contact];
    double largest = 0;
    for (const ContactResult& c : result.contacts)
        if (c.part[0] == own.part[0] || c.part[0] == own.part[1] || c.part[1] == own.part[0] || c.part[1] == own.part[1])
            largest = std::max(largest, c.force.norm());
    const double beside = own.force.norm() > 0 ? largest / own.force.norm() : 1;
    return std::max({change, of_stiffness, std::min(1.0, shared * energy * beside)});
}

/// What is to be said of largest pressures.
struct DoubtfulPeaks {
    std::vector<Finding> at_corner, uncertain;
};

/// target: of the accuracy. Peaks of contacts that carry next to nothing are told, but speak against nothing. A pressure is
/// known no better than the force that it adds up to (Cauchy and Schwarz: Hertz' by 0.96 of it at least), the largest one and
/// the length of Hertz' by half of it; but a resultant's error, where pressures balance each other, is a small one of theirs.
void fill_contact(const ContactError& e, bool at_corner, double of_force, double target, std::size_t k, ContactResult& c,
                  DoubtfulPeaks& peaks) {
    const bool counts = e.share_of_peak * (at_corner ? 1 : e.peak) > target;
    const double of_level = e.of_integral * of_force, pressure = std::max(e.pressure, of_level);
    c.error_estimate = pressure;
    c.errors =
        ContactErrors{pressure, std::max(e.peak, 0.5 * of_level), of_force, std::max(e.length, 0.5 * of_level), at_corner};
    if (c.friction) c.friction->stick_length_error = e.stick_length;
    const std::string name = "contact " + contact_number(k), largest = "the largest pressure of " + name,
                      corner = c.kind == "bonded" ? "the end of the bond" : "a sharp corner";
    if (at_corner)
        peaks.at_corner.push_back({c.max_pressure.value, name,
                                   largest + " stands at " + corner + ", where it grows with every finer grid (by " +
                                       percent_text(e.peak) + " yet, or more); error estimates leave out what is beside it",
                                   counts ? largest + " stands at " + corner + ", where it has no limit" : ""});
    else if (e.peak > doubtful && c.max_pressure.value > 0)
        peaks.uncertain.push_back(
            {e.peak, name,
             largest + " is uncertain by " + percent_text(std::min(e.peak, 1.0)) + ": the grids are too coarse for it",
             counts ? largest + " known to " + percent_text(std::min(e.peak, 1.0)) : ""});
}

std::string why_it_ended(const Outcome& out) {
    const PathEnd end = out.end;
    if (end == PathEnd::too_deep) return out.why;
    if (end == PathEnd::finer_failed) return out.why;
    if (end == PathEnd::out_of_budget && out.next)
        return "the next grids, " + cost_text(*out.next) + ", would go beyond the budget";
    if (end == PathEnd::out_of_cells)
        return "the grids have as many cells as they may; more memory, asked for as the budget, allows more";
    if (end == PathEnd::fixed_grids)
        return "the scene gives the grids; \"adapt\": true lets those of a cell_size follow the target";
    if (end == PathEnd::out_of_digits) return "rounding hides what finer grids would change";
    return "finer grids do not bring it down: a stress without limit at a sharp corner, or contact that comes and goes";
}

/// By how much a contact's pressure, or its traction over the bound, depends on the size of friction's increments.
double increments_share(const SolvedAssembly& solved, std::size_t contact) {
    if (contact >= solved.shear_of.size() || solved.shear_of[contact] < 0 || solved.solution.friction.empty()) return 0;
    return solved.solution.friction[static_cast<std::size_t>(solved.shear_of[contact])].error;
}

/// With errors of the pressure that no grid shows: a penalty's penetration, friction's increments, pairs of where parts were
/// drawn, and how stiff parts are on all of them. A peak that is too low under the same force has its pressure over too long a
/// contact, which in L2 is twice as much: it ends like the root of the distance (Hertz: 1.9 to 2.2 times for peaks off by 2 to
/// 0.5 %).
ErrorEstimate with_errors_of_model(ErrorEstimate e, const SolvedAssembly& solved, const std::vector<double>& of_pairs) {
    for (std::size_t k = 0; k < e.contacts.size(); ++k) {
        const double penetration = k < solved.contacts.size() ? penetration_share(solved, k) : 0,
                     pairs = at_or_zero(of_pairs, k), increments = increments_share(solved, k),
                     stiffness = e.contacts[k] ? e.contacts[k]->of_stiffness : 0;
        if (!e.contacts[k] || (penetration == 0 && pairs == 0 && increments == 0 && stiffness == 0)) continue;
        ContactError& c = *e.contacts[k];
        c.pressure = std::hypot(std::hypot(c.pressure, penetration, 2 * pairs), increments, stiffness);
        c.peak = std::hypot(std::hypot(c.peak, penetration, pairs), 0.5 * stiffness);
        c.length = std::hypot(c.length, pairs, 0.5 * stiffness);
        e.contact_pressure = std::max(*e.contact_pressure, c.share * c.pressure);
        if (!c.at_corner) e.peak = std::max(*e.peak, c.share_of_peak * c.peak);
    }
    return e;
}

/// What largest pressures of contacts err by: by their pairs, and by half of what their forces do (as in Hertz').
std::vector<double> peaks_of_model(const Outcome& out, const ModelErrors& of_model) {
    const std::vector<std::optional<ContactError>>& of_grids = out.errors.back().contacts;
    std::vector<double> of_peaks(std::max(of_model.of_pairs.size(), of_grids.size()));
    for (std::size_t k = 0; k < of_peaks.size(); ++k) {
        const double integral = k < of_grids.size() && of_grids[k] ? of_grids[k]->of_integral : 0;
        of_peaks[k] = std::hypot(at_or_zero(of_model.of_pairs, k), 0.5 * integral * force_error_of(of_model, k));
    }
    return of_peaks;
}

std::string moved_text(std::size_t k, const Result& result) {
    const ContactResult& c = result.contacts[k];
    return "contact " + contact_number(k) + " is paired where its parts are drawn, and they move away from there; draw " +
           c.parts[0] + " and " + c.parts[1] + " to each other as they come to rest";
}

/// Why the error is above the target, where that of the grids is not.
std::string why_by_model(const Outcome& out, const std::vector<double>& of_pairs, const std::vector<double>& of_points,
                         const Result& result) {
    for (std::size_t k = 0; k < out.solved.contacts.size(); ++k)
        if (penetration_share(out.solved, k) > 0)
            return "the penalty lets the bodies penetrate by a notable share of what they yield elastically; take a larger "
                   "contacts.penalty, or none";
    for (std::size_t k = 0; k < out.solved.contacts.size(); ++k)
        if (increments_share(out.solved, k) > 0.5 * out.target)
            return "what slips in contact " + contact_number(k) +
                   " depends on the way of the loads more closely than it could be followed; give them in steps";
    for (std::size_t k = 0; k < out.solved.contacts.size(); ++k)
        if (const std::optional<ContactError>& e = out.errors.back().contacts[k]; e && e->share * e->of_stiffness > out.target)
            return "contact " + contact_number(k) +
                   " bears a small difference, between how far its parts would go and how far they may: their stiffness "
                   "decides "
                   "it, which is known to less; round the corners where the stress has no limit, or take the next accuracy";
    std::size_t worst = 0;
    double most = 0;
    for (std::size_t k = 0; k < of_pairs.size(); ++k) {
        const std::optional<ContactError>& e = out.errors.back().contacts[k];
        if (!e || e->share_of_peak * of_pairs[k] <= most) continue;
        worst = k;
        most = e->share_of_peak * of_pairs[k];
    }
    if (at_or_zero(of_points, worst) > of_pairs[worst])  // a peak errs by half as much as the force
        return "contact " + contact_number(worst) +
               " shares its load with points that are held, which bear the less the smaller the cells are there; hold edges";
    return moved_text(worst, result);
}

/// Of contacts without an estimate.
void tell_moved_pairs(const ErrorEstimate& error, const std::vector<double>& of_pairs, double target, Result& result) {
    std::vector<Finding> findings;
    for (std::size_t k = 0; k < of_pairs.size(); ++k) {
        if (2 * of_pairs[k] <= target || (k < error.contacts.size() && error.contacts[k])) continue;
        const std::string known = percent_text(std::min(1.0, of_pairs[k]));
        findings.push_back({of_pairs[k], "contact " + contact_number(k),
                            "the largest pressure is off by about " + known + ": " + moved_text(k, result),
                            "the largest pressure of contact " + contact_number(k) + " known to " + known});
    }
    tell(std::move(findings), "moved_pairs", result);
}

void fill_target(const Outcome& out, const ErrorEstimate& error, const std::vector<double>& of_pairs,
                 const std::vector<double>& of_points, Result& result) {
    result.accuracy.of = error.contact_pressure                ? "contact pressure"
                         : error.largest_stress > error.stress ? "largest stress"
                                                               : "stress in the energy norm";
    result.accuracy.target = out.target;
    result.accuracy.estimate = steering(error);
    const bool is_of_one_grid = out.end != PathEnd::no_need && !error.contact_pressure && any_stretch(out.solved);
    result.accuracy.reached = !is_of_one_grid && result.accuracy.estimate && *result.accuracy.estimate <= out.target;
    const std::optional<double> of_grids = steering(out.errors.back());
    double by_points = 0;
    for (std::size_t k = 0; k < error.contacts.size(); ++k)
        if (error.contacts[k]) by_points = std::max(by_points, error.contacts[k]->share * at_or_zero(of_points, k));
    const bool is_by_model =
        !is_of_one_grid && of_grids && (*of_grids <= out.target || *of_grids <= by_points) && !result.accuracy.reached;
    if (result.accuracy.reached || (!is_by_model && (out.end == PathEnd::no_need || out.end == PathEnd::reached))) return;
    result.accuracy.why = is_by_model ? why_by_model(out, of_pairs, of_points, result) : why_it_ended(out);
    if (is_of_one_grid) {
        tell({{0, "",
               "contact pressures are of one grid alone, which does not tell how far they are off: " + result.accuracy.why,
               "contact pressures of one grid alone, which may be far off"}},
             "accuracy", result);
        return;
    }
    const double known_to = result.accuracy.estimate.value_or(1);
    const std::string target = percent_text(out.target), estimate = percent_beside(known_to, out.target);
    tell({{0, "",
           "the estimated error of the " + result.accuracy.of + ", " + estimate + ", is above the " + target +
               " aimed at: " + result.accuracy.why,
           (error.contact_pressure ? "contact pressures" : "stresses") + (" known to " + estimate + ", not to " + target)}},
         "accuracy", result);
}

}  // namespace

void fill_errors(const Outcome& out, const ModelErrors& of_model, Result& result) {
    for (std::size_t k = 0; k < out.passes.size(); ++k)
        result.passes.push_back(
            {out.passes[k].unknowns, out.passes[k].multipliers, out.passes[k].seconds, steering(out.errors[k])});
    const std::vector<double> of_peaks = peaks_of_model(out, of_model);
    const ErrorEstimate error = with_errors_of_model(out.errors.back(), out.solved, of_peaks);
    fill_target(out, error, of_peaks, of_model.of_points, result);
    tell_moved_pairs(error, of_peaks, out.target, result);
    if (!error.energy && !error.contact_pressure) {
        result.error_estimate.method = "none: nothing is strained";
        return;
    }
    result.error_estimate.method = error.contact_pressure
                                       ? "fit of the root at free ends of contact; elsewhere a share of the change between the "
                                         "last two grids, or the distance from the theory of half planes; energy, "
                                         "stress: smoothed stresses"
                                       : "smoothed stresses beside those of the displacement, in the energy norm; at the "
                                         "largest stress, there alone, and its change between the last two grids";
    result.error_estimate.energy = error.energy;
    result.error_estimate.contact_pressure = error.contact_pressure;
    result.error_estimate.stress = error.stress;
    DoubtfulPeaks peaks;
    constexpr double grows = 1e-9;  // of a pressure: the corner of a uniform stress has one with a limit
    const std::vector<char> is_static = given_by_statics(out.solved);
    for (std::size_t k = 0; k < result.contacts.size() && k < error.contacts.size(); ++k)
        if (const std::optional<ContactError>& e = error.contacts[k]) {
            const double of_force = force_error(out, error, result, k, k < is_static.size() && is_static[k]);
            const bool at_corner = e->at_corner || (k < of_model.at_ends.size() && of_model.at_ends[k]);
            fill_contact(*e, at_corner && e->peak > grows, std::max(of_force, force_error_of(of_model, k)), out.target, k,
                         result.contacts[k], peaks);
        }
    if (!result.accuracy.why.empty())  // the verdict has a worse word already
        for (Finding& f : peaks.uncertain) f.reason.clear();
    tell(std::move(peaks.at_corner), "corner", result);
    tell(std::move(peaks.uncertain), "peak", result);
}

void fill_missed(const Outcome& out, Result& result) {
    std::vector<Finding> findings;
    const MissedContacts missed = missed_contacts(out.solved, out.seen, out.target);
    for (std::size_t k = 0; k < missed.size(); ++k)
        for (const MissedContact& m : missed[k]) {
            const std::string pair = result.contacts[k].between[0] + " and " + result.contacts[k].between[1];
            findings.push_back({m.depth, pair,
                                pair + " overlap by " + number_text(m.depth, 3) +
                                    " where no contact was found: the cells are too coarse there for a force of up to " +
                                    percent_text(std::min(1.0, m.share)) +
                                    " of the largest on one of them; ask for a higher accuracy",
                                pair + " overlap where no contact was found"});
        }
    if (!findings.empty()) result.accuracy.reached = false;
    tell(std::move(findings), "missed_contact", result);
}

/// What is still missing of displacements after a change from the grids before, at most, of that change.
constexpr double missing_of_displacement = 0.33;

/// The same of a part: what its contacts are estimated to miss of their pressures' changes, the worst of them.
double missing_of_moves(const Result& result, const ErrorEstimate& error, const std::string& part) {
    double most = 0;
    bool any = false;
    for (std::size_t k = 0; k < result.contacts.size() && k < error.contacts.size(); ++k) {
        const ContactResult& c = result.contacts[k];
        if (!error.contacts[k] || (c.parts[0] != part && c.parts[1] != part)) continue;
        any = true;
        const ContactError& e = *error.contacts[k];
        most = std::max(most, e.pressure < e.whole_change ? e.pressure / e.whole_change : 1);
    }
    return any ? std::min(most, missing_of_displacement) : missing_of_displacement;
}

namespace {

/// The largest error of the forces on a part, of the strongest one's pressure.
double missing_of_contacts(const Result& result, const ErrorEstimate& error, const std::string& part) {
    double strongest = 0, most = 0;
    for (std::size_t k = 0; k < result.contacts.size() && k < error.contacts.size(); ++k) {
        const ContactResult& c = result.contacts[k];
        if (!error.contacts[k] || !c.errors || (c.parts[0] != part && c.parts[1] != part)) continue;
        strongest = std::max(strongest, error.contacts[k]->share);
        most = std::max(most, error.contacts[k]->share * std::min(c.errors->force, c.errors->pressure));
    }
    return strongest > 0 ? most / strongest : 0;
}

/// The largest error of the pressure and the traction of a part's contacts with friction.
double missing_of_tractions(const Result& result, const std::string& part) {
    double most = 0;
    for (const ContactResult& c : result.contacts)
        if (c.friction && c.errors && (c.parts[0] == part || c.parts[1] == part)) most = std::max(most, c.errors->pressure);
    return most;
}

}  // namespace

void fill_displacement_errors(const Outcome& out, Result& result) {
    const ErrorEstimate& error = out.errors.back();
    if (!error.energy) return;
    const double energy = *error.energy;
    double largest = 0;
    for (const PartResult& p : result.parts) largest = std::max(largest, p.max_displacement.value);
    for (std::size_t k = 0; k < out.solved.grids.size(); ++k) {
        PartResult& p = result.parts[static_cast<std::size_t>(out.solved.grids[k].part)];
        if (p.max_displacement.value == 0) continue;
        double own = energy * largest / p.max_displacement.value;
        if (k < error.own_energy.size() && out.solved.problem.parts[k].free_motions.empty())
            own = std::max(error.own_energy[k], missing_of_contacts(result, error, p.name));
        own = std::max(own, out.largest[k].displacement_error / p.max_displacement.value);
        // what lifts off goes by where its contacts end, of which energies know little
        if (k < error.moved.size())
            own = std::max(own, missing_of_moves(result, error, p.name) * error.moved[k] / p.max_displacement.value);
        // what friction keeps of steps before does no work under the loads: it errs as the tractions that keep it
        if (const double missing = missing_of_tractions(result, p.name); missing > 0)
            own = std::max(own, missing * displacement_in_step(out.solved, k) / p.max_displacement.value);
        p.max_displacement_error = std::min(1.0, own);
    }
    if (result.accuracy.of != "contact pressure" || energy <= result.accuracy.target) return;
    const std::string known = percent_text(std::min(1.0, energy));
    tell({{energy, "",
           "displacements and the strain energy are uncertain by " + known +
               ": cells are too large where the stress has no limit (re-entrant corners, ends of supports); round the corners, "
               "ask "
               "for smaller cells there (accuracy.refine), or take the next accuracy",
           "displacements known to " + known}},
         "displacement", result);
}

namespace {

/// A place on a contact's face.
struct FacePlace {
    double distance;  ///< of the place asked for
    double pressure;
    Vec2 tangent;
};

/// The place of one of a contact's sides nearest to a point; nothing: the contact has no face.
std::optional<FacePlace> nearest_on_face(const ContactProfile& profile, int side, const Vec2& at) {
    const std::vector<double>&x = side == 0 ? profile.x : profile.x2, &y = side == 0 ? profile.y : profile.y2;
    std::optional<FacePlace> nearest;
    for (std::size_t k = 1; k < x.size(); ++k) {
        const Vec2 begin(x[k - 1], y[k - 1]), way = Vec2(x[k], y[k]) - begin;
        const double length = way.norm();
        if (length == 0) continue;
        const double t = std::clamp((at - begin).dot(way) / (length * length), 0.0, 1.0),
                     distance = (begin + t * way - at).norm();
        if (!nearest || distance < nearest->distance)
            nearest = {distance, (1 - t) * profile.pressure[k - 1] + t * profile.pressure[k], way / length};
    }
    return nearest;
}

double pull_across(const Stress& s, const Vec2& tangent) {
    const Vec2 n(-tangent.y(), tangent.x());
    return s.xx * n.x() * n.x() + s.yy * n.y() * n.y() + 2 * s.xy * n.x() * n.y();
}

/// What errors of friction's traction do to the stress along a face: the surface of a half plane is stretched by twice their
/// Hilbert transform, which in L2 is as large as they are.
double missing_of_friction(const ContactResult& c) {
    return c.friction ? 2 * c.errors->pressure * std::min(1.0, c.friction->coefficient) * c.max_pressure.value : 0;
}

}  // namespace

void fill_stress_errors(const Outcome& out, Result& result) {
    constexpr double on_face = 0.1;  // of the cell
    for (std::size_t k = 0; k < out.solved.grids.size(); ++k) {
        PartResult& p = result.parts[static_cast<std::size_t>(out.solved.grids[k].part)];
        if (!p.max_von_mises_error) continue;
        for (std::size_t i = 0; i < result.contacts.size(); ++i)
            for (int side = 0; side < 2; ++side) {
                const ContactResult& c = result.contacts[i];
                if (c.parts[static_cast<std::size_t>(side)] != p.name || !c.errors) continue;
                const std::optional<FacePlace> face = nearest_on_face(c.profile, side, p.max_von_mises.at);
                if (!face || face->distance > on_face * out.largest[k].cell) continue;
                // thick parts bear the tractions of thinner ones over more
                const double scale = out.solved.contacts[i].face.thickness / out.solved.grids[k].input.thickness,
                             missing = std::abs(pull_across(out.largest[k].stress, face->tangent) + scale * face->pressure),
                             of_pressure = c.errors->at_corner ? 0 : c.errors->peak * std::abs(face->pressure);
                p.max_von_mises_error = std::max(
                    *p.max_von_mises_error, (missing + scale * (of_pressure + missing_of_friction(c))) / p.max_von_mises.value);
            }
    }
}

namespace {

/// The largest stress whose part has a corner where it goes beyond `most` on smaller cells, the farthest of all; or nullptr.
const LargestStress* corner_beyond(const Outcome& out, double most) {
    const LargestStress* farthest = nullptr;
    for (const LargestStress& s : out.largest)
        if (s.corner && s.on_smaller_cells > (farthest ? farthest->on_smaller_cells : most)) farthest = &s;
    return farthest;
}

}  // namespace

void warn_of_largest_stress(const Outcome& out, Result& result) {
    const PartResult* most = most_stressed(result);
    if (!most || !is_strained(out.solved)) return;
    const std::string which = "the largest von Mises stress, " +
                              with_unit(most->max_von_mises.value, 4, result_units(result).stress) + " in " + most->name +
                              " at " + place_text(most->max_von_mises.at, model_size(result)) + ",";
    // with contact the answer is judged by its pressures
    const bool is_aimed_at = result.accuracy.of != "contact pressure";
    if (most->max_von_mises_at_corner)
        tell({{0, most->name,
               which + " has no limit there (a re-entrant corner, the end of a support or bond, the corner of a contact, or "
                       "where its friction turns round): it grows with every finer grid",
               is_aimed_at ? "the largest stress, in " + most->name + ", stands where it has no limit" : ""}},
             "corner", result);
    else if (const LargestStress* beyond = corner_beyond(out, most->max_von_mises.value)) {
        const std::size_t grid = static_cast<std::size_t>(beyond - out.largest.data());
        const std::string& where = result.parts[static_cast<std::size_t>(out.solved.grids[grid].part)].name;
        tell(
            {{0, most->name,
              which + " is the largest on this grid: that at the " +
                  (beyond->corner_is_held ? "end of a support " : "sharp corner ") +
                  (where == most->name ? "" : "of " + where + " ") + "at " +
                  place_text(beyond->corner->at, model_size(result)) + ", " +
                  with_unit(beyond->corner->value, 4, result_units(result).stress) +
                  " here, has no limit and exceeds it on finer ones" +
                  (beyond->corner_is_held ? "" : "; round the corner to know the stress there"),
              is_aimed_at ? "the stress at " + std::string(beyond->corner_is_held ? "the end of a support" : "a sharp corner") +
                                " of " + where + " has no limit"
                          : ""}},
            "corner", result);
    } else if (most->max_von_mises_error.value_or(0) > (is_aimed_at ? result.accuracy.target : doubtful))
        tell({{0, most->name,
               which + " is uncertain by " + percent_text(std::min(*most->max_von_mises_error, 1.0)) +
                   ": the grid is too coarse for it",
               result.accuracy.why.empty() ? "the largest stress is uncertain" : ""}},
             "stress", result);
}

namespace {

/// Passes that a finer target adds, of the last one's size.
constexpr double passes_added = 1.5;
constexpr double finer = 5;
/// Bounds on the growth of unknowns per fall of the error, as an exponent.
constexpr double least_growth = 0.1, most_growth = 1;
/// With contact, where the passes do not show it; without, errors of stress fall like the cells' area: most_growth.
constexpr double usual_growth = 0.5;

NextLevel next_target(double target) {
    for (const char* level : {"draft", "standard", "fine"}) {
        Accuracy accuracy;
        accuracy.level = level;
        if (target_of(accuracy) < target / 1.5) return {level, target_of(accuracy), 0};
    }
    return {number_text(target / finer, 2), target / finer, 0};
}

double stage_seconds_of(const Result& result, const std::string& stage) {
    for (const auto& [name, seconds] : result.timing)
        if (name == stage) return seconds;
    return 0;
}

}  // namespace

void predict_next_level(Result& result) {
    const auto& passes = result.passes;
    if (passes.empty() || !(result.accuracy.estimate && *result.accuracy.estimate > 0)) return;
    if (!result.accuracy.why.empty()) return;  // not even this level was reached
    // from the first pass with an estimate to the last
    const auto first =
        std::find_if(passes.begin(), passes.end(), [](const PassSummary& p) { return p.estimated_error.has_value(); });
    const PassSummary& last = passes.back();
    const double seconds_before = passes.size() > 1 ? passes[passes.size() - 2].seconds : 0.0;
    double growth = result.error_estimate.contact_pressure ? usual_growth : most_growth;
    if (first != passes.end() && *first->estimated_error > *last.estimated_error && last.unknowns > first->unknowns)
        growth = std::log(static_cast<double>(last.unknowns) / first->unknowns) /
                 std::log(*first->estimated_error / *last.estimated_error);
    growth = std::clamp(growth, least_growth, most_growth);
    NextLevel next = next_target(result.accuracy.target);
    const double more = std::pow(std::max(1.0, *last.estimated_error / next.target), growth);
    const double last_seconds = last.seconds - seconds_before;
    const double import = stage_seconds_of(result, "import");
    const double answers = std::max(0.0, stage_seconds_of(result, "total") - last.seconds - import);
    next.seconds = import + last.seconds + passes_added * last_seconds * std::pow(more, time_growth_exponent) + more * answers;
    result.next_level = next;
}

}  // namespace abut
