// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/error_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

/// Of the strongest contact's pressure: below, a bond's is rounding.
constexpr double rounding_of_pressure = 1e-9;
/// What is still missing after a change from the grids before, of that change. Measured on 150 pairs of grids of shrink_fit,
/// vise, case_a, wedge, case_b and pin_in_hole: median 0.33 where the knots stand at 0.5 to 0.95 of their distance before, 0 to
/// 0.17 where nearer; never taken for less than that, which is by chance.
constexpr double missing = 0.33, missing_at_least = 0.17, missing_per_refinement = 0.66;
/// The same of the largest pressure: 0.04 to 0.7 (shrink_fit, whose peak is a ripple); passes go on by it, so the upper end.
constexpr double missing_of_peak = 0.75;
/// Beside corners an error inside that seems to fall by more than this in one pass does so by chance (case_a: the change fell
/// to a ninth, the error not at all), and so does that of a peak whose cells are no finer.
constexpr double most_fall = 0.25;
/// Nor does it fall faster than splines of degree 2 approach a smooth function, by the spacing of their knots.
constexpr double order_of_fall = 3;
/// An error at the ends of contact shifts its force, the largest pressure by 0.01 to 0.3 of it, and the contact's length by
/// 0.1 to 1 (generated assemblies, and those of data/ at draft): of use where the change from the grid before is small by
/// chance. Ends of light tails move by more than the pressure there can tell: by what they still moved, or by all of a tail
/// that the pressure's error could take away.
constexpr double ends_in_peak = 0.3, ends_in_length = 1;
/// A change tells an error to within this factor (tests/verification/estimate_test.cpp): as far as that, theory is believed
/// where it says more of a peak; and beside corners an error is believed to fall faster.
constexpr double most_too_low = 2;
/// Fall of an error in one pass that was worth it.
constexpr double worthwhile = 0.7;
/// Of two grids' smoothed differences, from which on their ratio is known too badly to extrapolate.
constexpr double largest_ratio = 0.8;

double end_errors(const ContactRecord& c) {
    double square = 0;
    for (const PressedStretch& stretch : c.stretches)
        square += stretch.at_begin.error * stretch.at_begin.error + stretch.at_end.error * stretch.at_end.error;
    return std::sqrt(square);
}

bool has_corner(const ContactRecord& c) {
    return std::any_of(c.stretches.begin(), c.stretches.end(), [](const PressedStretch& stretch) {
        return stretch.at_begin.kind == StretchEnd::Kind::corner || stretch.at_end.kind == StretchEnd::Kind::corner;
    });
}

bool peak_at_corner(const ContactRecord& c, double peak) {
    const auto stands = [&](const StretchEnd& end, double s) {
        return end.kind == StretchEnd::Kind::corner && solver::pressure_at(c.pressure, c.coefficients, s) >= peak;
    };
    return std::any_of(c.stretches.begin(), c.stretches.end(), [&](const PressedStretch& stretch) {
        return stands(stretch.at_begin, stretch.begin) || stands(stretch.at_end, stretch.end);
    });
}

/// Changes that fall from grid to grid like a geometric series leave no more than its rest. They fall faster after a grid that
/// refined more than the next: at worst that halves the share.
double missing_share(const PressureChange& c, double change, const std::optional<ContactError>& before) {
    double most = std::min(missing, missing_per_refinement * c.refinement);
    if (before && change < before->change) most = std::min(most, change / (before->change - change));
    return std::max(missing_at_least, most);
}

/// The error inside by interval: a share of the change, and no less of the pressure than it was where the knots stand no
/// closer; but beside corners, whose error it is that the rest has.
void fill_local(const ContactRecord& now, const PressureChange& c, double share, ContactError& e) {
    const bool keeps = !has_corner(now);
    double square = 0;
    for (std::size_t i = 0; i < c.local.size(); ++i) {
        const double its = std::max(share * share * c.local[i].square / (c.norm * c.norm), keeps ? c.local[i].kept : 0);
        square += its;
        e.local.push_back(its / (now.pressure.breakpoints[i + 1] - now.pressure.breakpoints[i]));
    }
    e.inside = std::sqrt(square);
}

/// The length of a contact where something holds.
template <class Holds>
double length_where(const ContactRecord& c, Holds holds) {
    constexpr int samples = 8;  // by interval
    double length = 0;
    for (std::size_t i = 0; i + 1 < c.pressure.breakpoints.size(); ++i) {
        const double begin = c.pressure.breakpoints[i], step = (c.pressure.breakpoints[i + 1] - begin) / samples;
        for (int k = 0; k < samples; ++k)
            if (holds(begin + (k + 0.5) * step)) length += step;
    }
    return length;
}

/// The share of a contact's length whose pressure is below its error.
double share_of_tails(const ContactRecord& c, double error, double norm) {
    const double length = length_of(c.stretches), level = error * norm / std::sqrt(length);
    const auto is_light = [&](double s) {
        const double p = solver::pressure_at(c.pressure, c.coefficients, s);
        return p > 0 && p < level;
    };
    return length > 0 ? std::min(1.0, length_where(c, is_light) / length) : 0;
}

ContactError estimate(const ContactRecord& now, const PressureChange& c, const std::optional<ContactError>& before,
                      const std::optional<PlanePressure>& theory) {
    ContactError e;
    e.at_corner = peak_at_corner(now, c.peak);
    e.ends = end_errors(now) / c.norm;
    e.change = c.inside / c.norm;
    e.whole_change = c.difference / c.norm;
    fill_local(now, c, missing_share(c, e.change, before), e);
    e.kept = e.inside;
    // of a pressure that is even but for ripples the largest one is the peak, here or there
    const double of_peak = std::max(std::abs(c.peak - c.peak_before), c.around_peak);
    e.peak = std::max(missing_of_peak * of_peak / c.peak, ends_in_peak * e.ends);
    const double fall = std::min(1.0, std::pow(c.refinement, order_of_fall));
    if (before && has_corner(now)) {
        e.kept = std::max(e.inside, fall * before->kept);
        e.inside = std::max({e.inside, e.kept / most_too_low, most_fall * before->inside});
    }
    if (before && c.peak_stayed) e.peak = std::max(e.peak, std::max(fall, most_fall) * before->peak_inside);
    e.peak_inside = e.peak;
    e.peak = std::max(e.peak, missing_of_peak * c.at_ends / c.peak);
    e.force = missing * c.force_change;
    if (now.resultant && c.force != 0) e.of_integral = std::min(1.0, now.resultant->norm() / std::abs(c.force));
    e.length = std::max(ends_in_length * e.ends, c.ends_left);
    if (theory && are_of_one_zone(now, *theory)) {
        const PressureChange away = change_from(now, *theory);
        const double distance = std::hypot(away.inside / away.norm, e.force, theory->doubt);
        const double of_theory = std::abs(away.peak - away.peak_before) / away.peak;
        e.inside = std::min(e.inside, distance);
        e.peak = std::min(most_too_low * e.peak, std::max({of_theory, distance, ends_in_peak * e.ends}));
    }
    e.peak = std::max(e.peak, e.inside);  // no place is known better than the mean
    e.pressure = std::hypot(e.ends, e.inside);
    e.length = std::max(e.length, share_of_tails(now, e.pressure, c.norm));
    return e;
}

/// Of a contact that lies beside sharp corners as a whole, where pressures have no limit: its force, and what is known by that.
ContactError estimate_of_force(const ContactRecord& now, const ContactRecord& before, const PressureChange& c) {
    ContactError e;
    const auto missed = [](double now_is, double was) { return std::min(1.0, std::abs(now_is - was) / std::abs(now_is)); };
    e.at_corner = true;
    e.change = e.whole_change = std::min(1.0, c.force_change);
    e.force = e.pressure = e.inside = e.kept = missing * e.change;
    e.peak = e.peak_inside = std::max(e.pressure, missing_of_peak * missed(c.peak, c.peak_before));
    e.length = std::max(e.pressure, missing * missed(length_of(now.stretches), length_of(before.stretches)));
    e.local.assign(c.local.size(), 0);
    return e;
}

/// A traction that ends like a root somewhere between knots has an error in proportion to their spacing.
double missing_of_traction(double refinement) {
    return refinement < 1 ? std::clamp(refinement / (1 - refinement), missing_at_least, 1.0) : 1;
}

/// Length that sticks by less than a share of what friction bears there: where a traction comes to its bound without a kink
/// that is much of a contact.
double length_near_bound(const ContactRecord& c, double share) {
    return length_where(c, [&](double s) {
        const double left = 1 - std::abs(solver::pressure_at(c.pressure, c.shear->coefficients, s)) /
                                    (c.shear->coefficient * solver::pressure_at(c.pressure, c.coefficients, s));
        return left > slip_fraction && left < share;
    });
}

/// Friction's traction counts like the pressure, over its bound, or over the pressure where its coefficient is above 1. The
/// borders of slip are ends to it. Inside, where slip once ended, its roots are not where anything is known of them now.
void add_shear(const ContactRecord& now, const ContactRecord& before, double norm_of_pressure,
               const std::optional<ContactError>& known, ContactError& e) {
    if (!now.shear || !before.shear) return;
    const auto with_traction = [](ContactRecord record) {
        record.coefficients = record.shear->coefficients;
        record.stretches.insert(record.stretches.end(), record.shear->borders.begin(), record.shear->borders.end());
        return record;
    };
    const PressureChange c =
        change_of(with_traction(now), with_traction(before), known ? known->local_of_shear : std::vector<double>{});
    const double bound = std::min(1.0, now.shear->coefficient) * norm_of_pressure;
    double square = 0;
    for (std::size_t i = 0; i < c.local.size(); ++i) {
        const double share = missing_of_traction(c.local[i].refinement);
        const double its = std::max(share * share * c.local[i].square / (bound * bound), c.local[i].kept);
        square += its;
        e.local_of_shear.push_back(its / (now.pressure.breakpoints[i + 1] - now.pressure.breakpoints[i]));
    }
    const double of_length = ends_in_length * now.shear->border_error / bound * length_of(now.stretches);
    e.ends = std::max(e.ends, now.shear->border_error / bound);
    e.inside = std::max(e.inside, std::sqrt(square));
    e.pressure = std::max(e.pressure, std::hypot(now.shear->border_error / bound, std::sqrt(square)));
    const double most = std::max({std::abs(now.shear->stick_length - before.shear->stick_length), now.shear->unseen, of_length,
                                  length_near_bound(now, e.pressure)});
    e.stick_length = std::min(most, length_of(now.stretches));
}

}  // namespace

std::optional<double> steering(const ErrorEstimate& e) {
    if (e.contact_pressure) return std::max(*e.contact_pressure, *e.peak);
    return e.stress ? std::max(*e.stress, e.largest_stress.value_or(0)) : e.stress;
}

bool has_fallen(std::span<const ErrorEstimate> errors) {
    const std::size_t n = errors.size();
    return n < 2 || !errors[n - 2].contact_pressure ||
           *errors[n - 1].contact_pressure < worthwhile * *errors[n - 2].contact_pressure;
}

bool is_improving(std::span<const ErrorEstimate> errors) {
    const std::size_t n = errors.size();
    if (n < 4 || !errors[n - 1].contact_pressure || !errors[n - 3].contact_pressure) return true;
    return *errors[n - 1].contact_pressure < worthwhile * worthwhile * *errors[n - 3].contact_pressure;
}

bool go_astray(std::span<const ErrorEstimate> errors, std::size_t last_ones) {
    if (errors.size() < 2 * last_ones) return false;
    const auto least = [](std::span<const ErrorEstimate> some) {
        double error = 1;
        for (const ErrorEstimate& e : some) error = std::min(error, e.contact_pressure.value_or(1));
        return error;
    };
    return least(errors.last(last_ones)) >= least(errors.first(errors.size() - last_ones));
}

ErrorEstimate estimate_errors(std::span<const PassRecord> passes, const ErrorEstimate& estimate_before,
                              std::span<const std::optional<PlanePressure>> theory) {
    ErrorEstimate e;
    const PassRecord& now = passes.back();
    e.contacts.resize(now.contacts.size());
    e.moved.resize(now.moved.size());
    if (passes.size() < 2) return e;
    const PassRecord& before = passes[passes.size() - 2];
    if (before.contacts.size() != now.contacts.size()) return e;  // it had no answer (a step, or the one before it, was stuck)
    for (std::size_t k = 0; k < e.moved.size(); ++k) e.moved[k] = change_of_displacement(now, before, k);
    double strongest = 0, largest_peak = 0, largest_force = 0;  // of all, bonds among them
    std::vector<PressureChange> changes;
    for (std::size_t k = 0; k < now.contacts.size(); ++k) {
        const std::optional<ContactError> known =
            k < estimate_before.contacts.size() ? estimate_before.contacts[k] : std::nullopt;
        const bool is_open = now.contacts[k].stretches.empty();  // but for rounding
        changes.push_back(is_open
                              ? PressureChange()
                              : change_of(now.contacts[k], before.contacts[k], known ? known->local : std::vector<double>{}));
        const PressureChange& c = changes.back();
        if (c.norm > 0) {
            e.contacts[k] = estimate(now.contacts[k], c, known, k < theory.size() ? theory[k] : std::nullopt);
            add_shear(now.contacts[k], before.contacts[k], c.norm, known, *e.contacts[k]);
        } else if (c.force != 0) {
            e.contacts[k] = estimate_of_force(now.contacts[k], before.contacts[k], c);
        }
        strongest = std::max(strongest, c.norm);
        largest_peak = std::max(largest_peak, c.peak);
        largest_force = std::max(largest_force, std::abs(c.force));
    }
    double worst = 0, strongest_contact = 0, worst_peak = 0, largest_at_contact = 0;
    for (std::size_t k = 0; k < e.contacts.size(); ++k) {
        if (!e.contacts[k]) continue;
        ContactError& error = *e.contacts[k];
        error.share = changes[k].norm > 0 ? changes[k].norm / strongest : std::abs(changes[k].force) / largest_force;
        error.share_of_peak = changes[k].peak / largest_peak;
        const bool steers = !now.contacts[k].is_bond && changes[k].norm > 0;  // beside corners pressures settle last
        if (steers) {
            worst = std::max(worst, error.pressure * error.share);
            strongest_contact = std::max(strongest_contact, error.share);
            if (!error.at_corner) worst_peak = std::max(worst_peak, error.peak * changes[k].peak);
            largest_at_contact = std::max(largest_at_contact, changes[k].peak);
        }
        if (error.share <= rounding_of_pressure) e.contacts[k].reset();  // a bond that carries nothing
    }
    if (strongest_contact > 0) e.contact_pressure = worst / strongest_contact;
    if (strongest_contact > 0) e.peak = worst_peak / largest_at_contact;
    return e;
}

double energy_error_of(const EnergyOnGrid& before, const EnergyOnGrid& now) {
    if (now.smoothing > largest_ratio * before.smoothing) return now.smoothing;
    const double change = std::abs(now.energy - before.energy) / now.energy;
    return std::max(now.smoothing, change * now.smoothing / (before.smoothing - now.smoothing));
}

}  // namespace abut
