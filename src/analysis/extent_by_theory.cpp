// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/extent_by_theory.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "geometry/curves/gauss.hpp"
#include "src/solution/contact_joints.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

/// Inner knots of the pressure in a contact below which the grid does not tell its length: the fit of an end alone takes four
/// intervals (pressed_stretches), so a contact with two ends has eight.
constexpr int few_knots = 6;
/// Of the half width that was found: beyond, the parts are not like half planes. And knot spacings between a fillet's joint and
/// a contact's end that is put there: as far off as the first grids' ends are.
constexpr double most_extent = 2, near_joint = 2;
constexpr int stretch_samples = 16;            // along the stretch, between which the gap may be lowest
constexpr int gauss_points = 8;                // of the integral over the angle, between joints
constexpr int max_steps = 20;                  // of a root
constexpr double half_width_tolerance = 1e-4;  // relative
/// Half width over the hydraulic diameter of the thinner part, four times its area over its boundary (a strip's is twice its
/// thickness): what finite parts change is of the order of its square.
constexpr double small_contact = 0.025;

/// A stretch as one contact of half planes.
struct PlaneContact {
    double force;                       // per thickness and E*; of both halves
    double compliance;                  // 1 / E*
    double middle;                      // of the pressure, or the end of the interface where the stretch is half a contact
    double half_width;                  // as it was found
    double begin_spacing, end_spacing;  // of knots at its ends
};

/// Force per thickness and moment of a pressure, about s = 0.
struct ForceAlong {
    double force = 0, moment = 0;
};

ForceAlong force_between(const solver::KnotVector& knots, const Eigen::VectorXd& pressure, double begin, double end) {
    const geometry::GaussRule& rule = geometry::gauss_rule(knots.degree + 1);
    ForceAlong sum;
    for (int i = 0; i < knots.n_intervals(); ++i) {
        const double low = std::max(begin, knots.breakpoints[static_cast<std::size_t>(i)]),
                     length = std::min(end, knots.breakpoints[static_cast<std::size_t>(i) + 1]) - low;
        if (!(length > 0)) continue;
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double s = low + rule.points[q] * length;
            const double part = length * rule.weights[q] * solver::pressure_at(knots, pressure, s);
            sum.force += part;
            sum.moment += part * s;
        }
    }
    return sum;
}

/// Up to half way to the next stretches: a coarse pressure reaches beyond the ends that its force tells.
PlaneContact plane_contact(const ContactInterface& contact, const Eigen::VectorXd& pressure, double compliance,
                           const std::vector<PressedStretch>& stretches, std::size_t r) {
    const PressedStretch& stretch = stretches[r];
    const double low = r == 0 ? contact.s.front() : 0.5 * (stretches[r - 1].end + stretch.begin);
    const double high = r + 1 == stretches.size() ? contact.s.back() : 0.5 * (stretch.end + stretches[r + 1].begin);
    const auto [force, moment] = force_between(contact.face.pressure, pressure, low, high);
    const bool is_half = stretch.from_start || stretch.to_end;
    return {(is_half ? 2 : 1) * force * compliance,
            compliance,
            stretch.from_start ? stretch.begin : (stretch.to_end ? stretch.end : moment / force),
            (is_half ? 1 : 0.5) * (stretch.end - stretch.begin),
            spacing_at(contact.face.pressure, stretch.begin),
            spacing_at(contact.face.pressure, std::nextafter(stretch.end, stretch.begin))};
}

int knots_in(const ContactInterface& contact, const PressedStretch& stretch) {
    const std::vector<double>& knots = contact.face.pressure.breakpoints;
    return static_cast<int>(
        std::count_if(knots.begin(), knots.end(), [&](double s) { return stretch.begin < s && s < stretch.end; }));
}

/// d(drawn gap)/ds, from the directions of both surfaces.
std::optional<double> gap_slope(const Scene& scene, const ContactInterface& contact, double s) {
    const geometry::FacingPair pair = pair_at(scene, contact, s);
    if (!pair.found) return std::nullopt;
    Vec2 along(-pair.normal.y(), pair.normal.x());
    if (along.dot(pair.on1.tangent) < 0) along = -along;
    const Vec2 &n1 = pair.on1.normal, &n2 = pair.on2.normal;
    return n1.dot(along) / n1.dot(pair.normal) - n2.dot(along) / n2.dot(pair.normal);
}

/// Where within the stretch the drawn gap is lowest: a coarse pressure's middle is farther off than a small contact is wide.
std::optional<double> lowest_place(const Scene& scene, const ContactInterface& contact, const PressedStretch& stretch) {
    const auto place = [&](int i) { return stretch.begin + (stretch.end - stretch.begin) * i / stretch_samples; };
    std::optional<double> before = gap_slope(scene, contact, place(0));
    for (int i = 1; i <= stretch_samples; ++i) {
        const std::optional<double> now = gap_slope(scene, contact, place(i));
        if (before && now && *before < 0 && *now >= 0) {
            const auto slope = [&](double s) { return gap_slope(scene, contact, s).value_or(0); };
            const boost::math::tools::eps_tolerance<double> digits(std::numeric_limits<double>::digits - 4);
            std::uintmax_t steps = max_steps;
            const auto [low, high] =
                boost::math::tools::toms748_solve(slope, place(i - 1), place(i), *before, *now, digits, steps);
            return 0.5 * (low + high);
        }
        before = now;
    }
    return std::nullopt;
}

/// The drawn gap's derivative away from a middle; the mean of both sides, or of the one that there is.
class Profile {
public:
    Profile(const Scene& scene, const ContactInterface& contact, const std::vector<ContactJoint>& joints,
            const PressedStretch& stretch, double middle)
        : scene_(scene), contact_(contact), middle_(middle), has_left_(!stretch.from_start), has_right_(!stretch.to_end) {
        for (const ContactJoint& joint : joints) joints_.push_back(std::abs(joint.s - middle));
        std::sort(joints_.begin(), joints_.end());
    }

    double largest() const {
        double x = std::numeric_limits<double>::infinity();
        if (has_left_) x = std::min(x, middle_ - contact_.s.front());
        if (has_right_) x = std::min(x, contact_.s.back() - middle_);
        return x;
    }

    /// Places where it is not smooth, ascending.
    const std::vector<double>& joints() const { return joints_; }

    std::optional<double> slope(double x) const {
        double sum = 0;
        for (double side : {-1.0, 1.0}) {
            if (!(side < 0 ? has_left_ : has_right_)) continue;
            const std::optional<double> there = gap_slope(scene_, contact_, middle_ + side * x);
            if (!there) return std::nullopt;
            sum += side * *there;
        }
        return has_left_ && has_right_ ? 0.5 * sum : sum;
    }

private:
    const Scene& scene_;
    const ContactInterface& contact_;
    double middle_;
    bool has_left_, has_right_;
    std::vector<double> joints_;
};

/// Force per thickness over E* at which the contact is 2a wide.
std::optional<double> galin_integral(const Profile& profile, double a) {
    const geometry::GaussRule& rule = geometry::gauss_rule(gauss_points);
    std::vector<double> ends{0};  // of the angle
    for (double x : profile.joints())
        if (x > 0 && x < a) ends.push_back(std::asin(x / a));
    ends.push_back(0.5 * std::numbers::pi);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double x = a * std::sin(ends[i] + rule.points[q] * (ends[i + 1] - ends[i]));
            const std::optional<double> slope = profile.slope(x);
            if (!slope) return std::nullopt;
            sum += (ends[i + 1] - ends[i]) * rule.weights[q] * x * *slope;
        }
    return sum;
}

/// At most most_extent times what was found.
std::optional<double> half_width(const Profile& profile, const PlaneContact& plane) {
    bool is_known = true;
    // the root: linear in the half width for gaps that grow with the square
    const auto excess = [&](double a) {
        const std::optional<double> integral = galin_integral(profile, a);
        is_known = is_known && integral;
        return std::sqrt(std::max(0.0, integral.value_or(0))) - std::sqrt(plane.force);
    };
    const double largest = std::min(most_extent * plane.half_width, profile.largest());
    if (!(largest > 0)) return std::nullopt;
    const double at_largest = excess(largest);
    if (!is_known || !(at_largest > 0)) return std::nullopt;
    const auto is_near = [](double a, double b) { return std::abs(a - b) <= half_width_tolerance * b; };
    std::uintmax_t steps = max_steps;
    const auto [low, high] =
        boost::math::tools::toms748_solve(excess, 0.0, largest, -std::sqrt(plane.force), at_largest, is_near, steps);
    if (!is_known || !is_near(low, high)) return std::nullopt;
    return 0.5 * (low + high);
}

/// Nothing where the stretch stays as it was, or its pressure is unknown.
std::optional<PlaneStretch> move_by_galin(const Scene& scene, const ContactInterface& contact,
                                          const std::vector<ContactJoint>& joints, const PlaneContact& plane,
                                          PressedStretch& stretch) {
    const bool is_half = stretch.from_start || stretch.to_end;
    const double middle = is_half ? plane.middle : lowest_place(scene, contact, stretch).value_or(plane.middle);
    const Profile profile(scene, contact, joints, stretch, middle);
    const std::optional<double> a = half_width(profile, plane);
    if (!a) return std::nullopt;
    if (!stretch.from_start) stretch.begin = middle - *a;
    if (!stretch.to_end) stretch.end = middle + *a;
    return plane_stretch([&](double x) { return profile.slope(x); }, middle, *a, plane.force / plane.compliance);
}

/// The end at s, if a joint is near from which on the gap opens; outward: 1 or -1.
std::optional<double> end_beyond_joint(const std::vector<ContactJoint>& joints, const PlaneContact& plane, double s,
                                       int outward, double reach) {
    const ContactJoint* nearest = nullptr;
    for (const ContactJoint& joint : joints)
        if (outward * joint.opening > 0 && std::abs(joint.s - s) <= reach &&
            (nearest == nullptr || std::abs(joint.s - s) < std::abs(nearest->s - s)))
            nearest = &joint;
    if (nearest == nullptr) return std::nullopt;
    // the header's limit of a - b, for a flat with a centred load
    const double radius = 1 / std::abs(nearest->opening);
    const double beyond = std::pow(0.75 * plane.force * radius / std::sqrt(0.5 * plane.half_width), 2.0 / 3);
    if (beyond > reach) return std::nullopt;
    return nearest->s + outward * beyond;
}

/// Fillets of less than the knots' spacing seem to be pressed as far as they are looked at.
void move_to_fillets(const std::vector<ContactJoint>& joints, const PlaneContact& plane, PressedStretch& stretch) {
    const auto begin = end_beyond_joint(joints, plane, stretch.begin, -1, near_joint * plane.begin_spacing),
               end = end_beyond_joint(joints, plane, stretch.end, 1, near_joint * plane.end_spacing);
    if (begin) {
        stretch.from_start = stretch.from_start && *begin <= stretch.begin;
        if (!stretch.from_start) stretch.at_begin.kind = StretchEnd::Kind::free;
        stretch.begin = *begin;
    }
    if (end) {
        stretch.to_end = stretch.to_end && *end >= stretch.end;
        if (!stretch.to_end) stretch.at_end.kind = StretchEnd::Kind::free;
        stretch.end = *end;
    }
}

/// Half width over the parts' hydraulic diameter, the largest.
double largest_share(const SolvedAssembly& solved, const ContactInterface& contact,
                     const std::vector<PlaneStretch>& stretches) {
    double share = 0;
    for (int part : contact.face.part) {
        const PartOnGrid& g = solved.grids[static_cast<std::size_t>(part)];
        if (g.is_rigid) continue;
        double boundary = 0;
        for (const geometry::Edge& edge : g.local.edges) boundary += length(edge.curve);
        for (const PlaneStretch& stretch : stretches) share = std::max(share, stretch.half_width * boundary / (4 * g.area));
    }
    return share;
}

/// Statics know the force per length away from an axis only.
bool is_at_axis(const Scene& scene, const ContactInterface& contact, const PressedStretch& stretch) {
    if (scene.analysis != Analysis::axisymmetric) return false;
    const double reach = stretch.end - stretch.begin;
    const geometry::FacingPair begin = pair_at(scene, contact, stretch.begin), end = pair_at(scene, contact, stretch.end);
    return (begin.found && begin.on1.x.x() < reach) || (end.found && end.on1.x.x() < reach);
}

/// Puts the ends of one contact's stretches of fewer than so many knots where theory has them. Its pressure, where all of them
/// are such, small and of half planes.
std::optional<PlanePressure> place_stretches(const Scene& scene, const SolvedAssembly& solved, std::size_t k, int knots,
                                             std::vector<PressedStretch>& stretches) {
    const ContactInterface& contact = solved.contacts[k];
    const std::vector<ContactJoint> joints = contact_joints(scene, contact);
    const double compliance = compliance_of(solved, k);
    PlanePressure pressure{contact.s1, contact.s, {}};
    for (std::size_t r = 0; r < stretches.size(); ++r) {
        PressedStretch& stretch = stretches[r];
        if (is_at_axis(scene, contact, stretch)) continue;
        const bool is_whole = stretch.from_start && stretch.to_end;
        const PlaneContact plane = plane_contact(contact, pressure_of(solved, k), compliance, solved.stretches[k], r);
        if (!(plane.force > 0)) continue;
        if (!is_whole && knots_in(contact, stretch) < knots) {
            if (std::optional<PlaneStretch> known = move_by_galin(scene, contact, joints, plane, stretch))
                pressure.stretches.push_back(std::move(*known));
        } else {
            move_to_fillets(joints, plane, stretch);
        }
        stretch.begin = std::max(stretch.begin, contact.s.front());
        stretch.end = std::min(stretch.end, contact.s.back());
    }
    const double share = largest_share(solved, contact, pressure.stretches);
    pressure.doubt = share * share;
    if (pressure.stretches.size() < stretches.size() || share > small_contact || scene.analysis == Analysis::axisymmetric)
        return std::nullopt;
    return pressure;
}

/// Does theory know of such contacts? It knows of no bonds, and of no other springs than half planes.
bool is_told(const SolvedAssembly& solved, std::size_t k) {
    const ContactInterface& contact = solved.contacts[k];
    return !solved.stretches[k].empty() && !contact.face.bilateral && contact.pairing == Pairing::middle;
}

}  // namespace

TheoryOfContacts contacts_by_theory(const Scene& scene, const SolvedAssembly& solved) {
    TheoryOfContacts theory{solved.stretches, {}, true};
    theory.pressure.resize(theory.stretches.size());
    for (std::size_t k = 0; k < theory.stretches.size(); ++k) {
        if (theory.stretches[k].empty()) continue;
        if (is_told(solved, k)) theory.pressure[k] = place_stretches(scene, solved, k, few_knots, theory.stretches[k]);
        theory.is_close = theory.is_close && theory.pressure[k];
    }
    return theory;
}

void renew_pressures(const Scene& scene, const SolvedAssembly& solved, TheoryOfContacts& theory) {
    for (std::size_t k = 0; k < theory.pressure.size(); ++k) {
        std::vector<PressedStretch> stretches = solved.stretches[k];
        if (is_told(solved, k))
            theory.pressure[k] = place_stretches(scene, solved, k, std::numeric_limits<int>::max(), stretches);
    }
}

}  // namespace abut
