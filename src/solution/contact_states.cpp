// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/contact_states.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/base/index.hpp"

namespace abut {

namespace {

constexpr double under_pressure = 1e-9;  // of the largest coefficient: below, a pressure is rounding
constexpr double border_slack = 0.01;    // of a stretch: borders nearer to its end are part of that
constexpr int end_samples = 60;          // up to the reach of its end

const solver::Interface& along_face(const SolvedAssembly& solved, std::size_t contact) {
    return solved.problem.interfaces[at(solved.shear_of[contact])];
}

double pressure_in(const SolvedAssembly& solved, std::size_t contact, double s) {
    return solver::pressure_at(solved.contacts[contact].face.pressure, pressure_of(solved, contact), s);
}

double traction_in(const SolvedAssembly& solved, std::size_t contact, double s) {
    return solver::pressure_at(solved.contacts[contact].face.pressure, solved.solution.pressure[at(solved.shear_of[contact])],
                               s);
}

/// The traction over the root of an end's pressure, by the distance from that end: at its bound one way up to the distance
/// `width`; farther in it keeps what it had been before, that share of the bound, as far as it still sticks.
struct SlipAtEnd {
    double way, kept, width;

    double at(double x) const { return way * std::sqrt(x) - (way - kept) * std::sqrt(std::max(0.0, x - width)); }
};

/// Those whose force up to `reach` is `share` of what the bound would have there: of what carried no traction before, of what
/// had slipped the other way, and of what is pressed and sheared at once.
std::vector<SlipAtEnd> slips_of_force(double share, double reach) {
    std::vector<SlipAtEnd> slips{{0, share, 0}};
    for (const double way : {1.0, -1.0})
        for (const double kept : {0.0, -way}) {
            const double rest = std::clamp((way - share) / (way - kept), 0.0, 1.0);
            slips.push_back({way, kept, reach * (1 - std::cbrt(rest * rest))});
        }
    return slips;
}

/// L2 distance up to the reach of a free end between the traction and the nearest of these. place: by distance from the end.
template <class Place>
double misfit_at_end(const SolvedAssembly& solved, std::size_t contact, double reach, Place place) {
    double normal = 0, shear = 0;
    const double step = reach / end_samples;
    const auto distance = [=](int k) { return (k + 0.5) * step; };
    for (int k = 0; k < end_samples; ++k) {
        normal += step * friction_of(solved, contact) * pressure_in(solved, contact, place(distance(k)));
        shear += step * traction_in(solved, contact, place(distance(k)));
    }
    if (!(normal > 0)) return 0;
    const double amplitude = 1.5 * normal / (reach * std::sqrt(reach));
    double least = std::numeric_limits<double>::infinity();
    for (const SlipAtEnd& slip : slips_of_force(shear / normal, reach)) {
        double square = 0;
        for (int k = 0; k < end_samples; ++k)
            square += step * std::pow(traction_in(solved, contact, place(distance(k))) - amplitude * slip.at(distance(k)), 2);
        least = std::min(least, square);
    }
    return std::sqrt(least);
}

bool slips(FrictionState state) {
    return state == FrictionState::slip_forward || state == FrictionState::slip_backward;
}

}  // namespace

double friction_of(const SolvedAssembly& solved, std::size_t contact) {
    return solved.shear_of[contact] < 0 ? 0 : along_face(solved, contact).friction.value_or(0);
}

FrictionState state_at(const SolvedAssembly& solved, std::size_t contact, double s) {
    const double pressure = pressure_in(solved, contact, s), traction = traction_in(solved, contact, s);
    if (!(pressure > under_pressure * pressure_of(solved, contact).maxCoeff())) return FrictionState::open;
    if (std::abs(traction) < (1 - slip_fraction) * friction_of(solved, contact) * pressure) return FrictionState::stick;
    return traction < 0 ? FrictionState::slip_forward : FrictionState::slip_backward;
}

namespace {

/// How near to an end of contact no border is looked for.
double unseen_beside(const PressedStretch& stretch, const StretchEnd& end) {
    return std::max(end.reach / error_reach, border_slack * (stretch.end - stretch.begin));
}

}  // namespace

std::vector<StickBorder> stick_borders(const SolvedAssembly& solved, std::size_t contact) {
    std::vector<StickBorder> borders;
    const double coefficient = friction_of(solved, contact);
    if (coefficient == 0 || std::isinf(coefficient) || solved.stretches[contact].empty()) return borders;
    const auto is_within = [&](double s) {
        return std::any_of(solved.stretches[contact].begin(), solved.stretches[contact].end(),
                           [&](const PressedStretch& stretch) {
                               return s > stretch.begin + unseen_beside(stretch, stretch.at_begin) &&
                                      s < stretch.end - unseen_beside(stretch, stretch.at_end);
                           });
    };
    const Eigen::VectorXd bound = coefficient * pressure_of(solved, contact);
    const Eigen::VectorXd& traction = solved.solution.pressure[at(solved.shear_of[contact])];
    const double rounding = under_pressure * bound.maxCoeff();
    for (const double way : {1.0, -1.0}) {
        const Eigen::VectorXd left = bound + way * traction;  // nothing but rounding where all of it slips
        for (const PressedStretch& stretch :
             pressed_stretches(solved.contacts[contact].face.pressure, (left.array() > rounding).select(left, 0.0).matrix())) {
            if (!stretch.from_start && is_within(stretch.begin)) borders.push_back({stretch.begin, -1, stretch.at_begin});
            if (!stretch.to_end && is_within(stretch.end)) borders.push_back({stretch.end, 1, stretch.at_end});
        }
    }
    std::sort(borders.begin(), borders.end(), [](const auto& a, const auto& b) { return a.s < b.s; });
    return borders;
}

double traction_error_at_ends(const SolvedAssembly& solved, std::size_t contact) {
    if (std::isinf(friction_of(solved, contact))) return 0;
    double squares = 0;
    for (const PressedStretch& stretch : solved.stretches[contact]) {
        if (stretch.at_begin.kind == StretchEnd::Kind::free)
            squares += std::pow(
                misfit_at_end(solved, contact, stretch.at_begin.reach, [&](double x) { return stretch.begin + x; }), 2);
        if (stretch.at_end.kind == StretchEnd::Kind::free)
            squares +=
                std::pow(misfit_at_end(solved, contact, stretch.at_end.reach, [&](double x) { return stretch.end - x; }), 2);
    }
    return std::sqrt(squares);
}

FrictionSums friction_sums(const SolvedAssembly& solved, std::size_t contact) {
    FrictionSums sums;
    const solver::Interface& face = along_face(solved, contact);
    for (const solver::InterfacePoint& p : face.points) {
        const double weight = p.weight * face.thickness;
        sums.normal += weight * pressure_in(solved, contact, p.s);
        sums.shear += weight * traction_in(solved, contact, p.s);
    }
    return sums;
}

FrictionLengths friction_lengths(const SolvedAssembly& solved, std::size_t contact, const std::vector<StickBorder>& borders) {
    FrictionLengths lengths;
    for (const PressedStretch& stretch : solved.stretches[contact]) {
        std::vector<double> cuts{stretch.begin};
        for (const StickBorder& border : borders)
            if (border.s > stretch.begin && border.s < stretch.end) cuts.push_back(border.s);
        cuts.push_back(stretch.end);
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const bool is_slip = slips(state_at(solved, contact, 0.5 * (cuts[k] + cuts[k + 1])));
            (is_slip ? lengths.slip : lengths.stick) += cuts[k + 1] - cuts[k];
            if (is_slip) continue;
            // what slips within the first few knots is smeared over these
            if (k == 0) lengths.unseen += std::max(stretch.at_begin.reach, unseen_beside(stretch, stretch.at_begin));
            if (k + 2 == cuts.size()) lengths.unseen += std::max(stretch.at_end.reach, unseen_beside(stretch, stretch.at_end));
        }
    }
    return lengths;
}

}  // namespace abut
