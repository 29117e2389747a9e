// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/extent_by_theory.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "geometry/gauss.hpp"
#include "src/contact_joints.hpp"

namespace abut {

namespace {

constexpr int few_intervals = 6;  // of the pressure's knots in a contact
constexpr int samples = 48;       // of the pressure along the run
constexpr int gauss_points = 8;   // of the integral over the angle, between joints
constexpr int max_steps = 20;
constexpr double tolerance = 1e-4;  // of the half width
constexpr double most_growth = 2;   // of the half width that was found: beyond, the parts are not like half planes
constexpr double near_joint = 2;    // knot spacings between a fillet's joint and a contact's end that is put there

struct RunLoad {
    double force = 0, middle = 0;  // per thickness
};

RunLoad load_of(const ContactInterface& contact, const Eigen::VectorXd& pressure, const ContactRun& run) {
    RunLoad load;
    const double step = (run.end - run.begin) / samples;
    for (int i = 0; i < samples; ++i) {
        const double s = run.begin + (i + 0.5) * step, force = step * solver::pressure_at(contact.face.pressure, pressure, s);
        load.force += force;
        load.middle += force * s;
    }
    load.middle /= load.force;
    return load;
}

/// 1 / E', E' = E in plane stress, E / (1 - nu^2) in plane strain.
double half_plane_compliance(const PartOnGrid& g) {
    const solver::Elasticity& d = g.input.elasticity;
    return g.is_rigid ? 0 : d.d11 / (d.d11 * d.d11 - d.d12 * d.d12);
}

int intervals_in(const ContactInterface& contact, const ContactRun& run) {
    const std::vector<double>& knots = contact.face.pressure.breakpoints;
    return static_cast<int>(std::count_if(knots.begin(), knots.end(), [&](double s) { return run.begin < s && s < run.end; }));
}

/// The drawn gap's derivative, away from a place; the mean of both sides, or of the one that there is.
class Profile {
public:
    Profile(const Scene& scene, const ContactInterface& contact, const ContactRun& run, double middle)
        : scene_(scene), contact_(contact), middle_(middle), has_left_(!run.from_start), has_right_(!run.to_end) {
        for (const ContactJoint& joint : contact_joints(scene, contact)) joints_.push_back(std::abs(joint.s - middle));
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
            const geometry::FacingPair pair = pair_at(scene_, contact_, middle_ + side * x);
            if (!pair.found) return std::nullopt;
            Vec2 along(-pair.normal.y(), pair.normal.x());
            if (along.dot(pair.on1.tangent) < 0) along = -along;
            const Vec2 &n1 = pair.on1.normal, &n2 = pair.on2.normal;
            sum += side * (n1.dot(along) / n1.dot(pair.normal) - n2.dot(along) / n2.dot(pair.normal));
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

/// force: over E*; found: about this, or less.
std::optional<double> half_width(const Profile& profile, double force, double found) {
    bool is_known = true;
    // the root: linear in the half width for gaps that grow with the square
    const auto excess = [&](double a) {
        const std::optional<double> integral = galin_integral(profile, a);
        is_known = is_known && integral;
        return std::sqrt(std::max(0.0, integral.value_or(0))) - std::sqrt(force);
    };
    const double largest = std::min(most_growth * found, profile.largest()), at_largest = excess(largest);
    if (!is_known || !(at_largest > 0)) return std::nullopt;
    const auto is_near = [](double a, double b) { return std::abs(a - b) <= tolerance * b; };
    std::uintmax_t steps = max_steps;
    const auto [low, high] =
        boost::math::tools::toms748_solve(excess, 0.0, largest, -std::sqrt(force), at_largest, is_near, steps);
    if (!is_known || !is_near(low, high)) return std::nullopt;
    return 0.5 * (low + high);
}

/// force: per thickness and E*.
void move_by_galin(const Scene& scene, const ContactInterface& contact, const RunLoad& load, ContactRun& run) {
    const bool is_half = run.from_start || run.to_end;
    const double middle = run.from_start ? run.begin : run.to_end ? run.end : load.middle;
    const Profile profile(scene, contact, run, middle);
    const double found = is_half ? run.end - run.begin : 0.5 * (run.end - run.begin);
    const std::optional<double> a = half_width(profile, (is_half ? 2 : 1) * load.force, found);
    if (!a) return;
    if (!run.from_start) run.begin = middle - *a;
    if (!run.to_end) run.end = middle + *a;
}

/// The end at s, if a joint is near from which on the gap opens; outward: 1 or -1.
std::optional<double> end_beyond_joint(const std::vector<ContactJoint>& joints, double s, int outward, double reach,
                                       double half_width, double force) {
    const ContactJoint* nearest = nullptr;
    for (const ContactJoint& joint : joints)
        if (outward * joint.opening > 0 && std::abs(joint.s - s) <= reach &&
            (nearest == nullptr || std::abs(joint.s - s) < std::abs(nearest->s - s)))
            nearest = &joint;
    if (nearest == nullptr) return std::nullopt;
    const double radius = 1 / std::abs(nearest->opening);
    const double beyond = std::pow(0.75 * force * radius / std::sqrt(0.5 * half_width), 2.0 / 3);
    if (beyond > reach) return std::nullopt;
    return nearest->s + outward * beyond;
}

void move_to_fillets(const Scene& scene, const ContactInterface& contact, const RunLoad& load, ContactRun& run) {
    const std::vector<ContactJoint> joints = contact_joints(scene, contact);
    if (joints.empty()) return;
    const bool is_half = run.from_start || run.to_end;
    const double force = (is_half ? 2 : 1) * load.force, half_width = (is_half ? 1 : 0.5) * (run.end - run.begin);
    const std::vector<double>& knots = contact.face.pressure.breakpoints;
    const auto reach = [&](double s) {
        const auto i = static_cast<std::size_t>(solver::interval_of(contact.face.pressure, s));
        return near_joint * (knots[i + 1] - knots[i]);
    };
    const ContactRun found = run;
    if (!run.from_start)
        run.begin = end_beyond_joint(joints, found.begin, -1, reach(found.begin), half_width, force).value_or(found.begin);
    if (!run.to_end) run.end = end_beyond_joint(joints, found.end, 1, reach(found.end), half_width, force).value_or(found.end);
}

}  // namespace

std::vector<std::vector<ContactRun>> runs_by_theory(const Scene& scene, const SolvedAssembly& solved) {
    std::vector<std::vector<ContactRun>> runs = solved.runs;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const ContactInterface& contact = solved.contacts[k];
        if (runs[k].empty() || contact.face.bilateral || contact.pairing != Pairing::middle) continue;
        double both = 0;
        for (int part : contact.face.part) both += half_plane_compliance(solved.grids[static_cast<std::size_t>(part)]);
        for (ContactRun& run : runs[k]) {
            RunLoad load = load_of(contact, pressure_of(solved, k), run);
            if (!(both > 0) || !(load.force > 0) || (run.from_start && run.to_end)) continue;
            load.force *= both;
            if (intervals_in(contact, run) < few_intervals)
                move_by_galin(scene, contact, load, run);
            else
                move_to_fillets(scene, contact, load, run);
        }
    }
    return runs;
}

}  // namespace abut
