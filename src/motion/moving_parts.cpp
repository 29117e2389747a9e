// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/moving_parts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "solver/contact/rigid_settle.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/contact/candidates.hpp"
#include "src/plan/support_wrenches.hpp"

namespace abut {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using geometry::Screw;

/// An orthonormal basis of what wrenches (about the origin) leave free.
Eigen::Matrix3Xd free_motions(const std::vector<Screw>& wrenches, const Vec2& center, double arm) {
    constexpr double free = 1e-9;
    Eigen::Matrix3d held = Eigen::Matrix3d::Zero();
    for (const Screw& w : wrenches) {
        const Vec2 force(w[0], w[1]);
        const Eigen::Vector3d row(w[0], w[1], (w[2] - geometry::cross(center, force)) / arm);
        held += row.normalized() * row.normalized().transpose();
    }
    if (wrenches.empty()) return Eigen::Matrix3d::Identity();
    const solver::SymmetricEigen eigen = solver::symmetric_eigen(held);
    return eigen.vectors.leftCols((eigen.values.array() < free).count());
}

/// A force's power in a part's motions.
VectorXd power(const MovingPart& p, const Vec2& force, double moment) {
    return p.motions.transpose() * Eigen::Vector3d(force.x(), force.y(), moment / p.arm);
}

Eigen::Vector3d load_of(const MovingPart& p) {
    return {p.load.force.x(), p.load.force.y(), p.load.moment / p.arm};
}

/// The centroid of a part, or of some.
Vec2 middle_of(const Scene& scene, const std::vector<std::size_t>& parts) {
    if (parts.size() == 1) return centroid(scene.parts[parts.front()].part);
    Vec2 sum(0, 0);
    double all = 0;
    for (const std::size_t i : parts) {
        const double own = area(scene.parts[i].part);
        sum += own * centroid(scene.parts[i].part);
        all += own;
    }
    return sum / all;
}

/// Twice the distance of the farthest point of some parts from their middle: the same however they are turned.
double size_of(const Scene& scene, const std::vector<std::size_t>& parts) {
    const Vec2 middle = middle_of(scene, parts);
    double farthest = 0;
    for (const std::size_t i : parts)
        for (const geometry::Edge& edge : scene.parts[i].part.edges)
            for (const double t : {0.0, 0.25, 0.5, 0.75}) farthest = std::max(farthest, (point(edge.curve, t) - middle).norm());
    return 2 * farthest;
}

/// The same load about another point than `from`.
RigidLoad about(const Vec2& center, RigidLoad load, const Vec2& from) {
    load.moment += geometry::cross(from - center, load.force);
    load.stretch += load.force.dot(from - center);
    return load;
}

/// The rows of a step's problem, one after the other.
class Rows {
public:
    Rows(const MovingParts& moving, Index n, solver::ContactQp& qp) : moving_(moving), qp_(qp) {
        qp.modes = Eigen::MatrixXd::Zero(n, moving.n);
        qp.drawn_gap = qp.foundation = VectorXd::Zero(n);
        qp.unilateral.assign(static_cast<std::size_t>(n), 0);
    }

    void gap(const ClosingRow& row, double stiffness) {
        qp_.drawn_gap[k_] = row.gap;
        qp_.unilateral[static_cast<std::size_t>(k_)] = 1;
        side(row.first, row.x1, -row.normal);
        side(row.second, row.x2, row.normal);
        qp_.foundation[k_++] = stiffness;
    }
    void across(const ClosingRow& row, double stiffness) {
        const Vec2 t = geometry::left_of(row.normal);
        side(row.first, row.pivot1, -t);
        side(row.second, row.pivot2, t);
        qp_.foundation[k_++] = stiffness;
    }
    /// Of tractions at the points themselves.
    void along(const ClosingRow& row, double stiffness) {
        const Vec2 t = geometry::left_of(row.normal);
        side(row.first, row.x1, -t);
        side(row.second, row.x2, t);
        qp_.foundation[k_++] = stiffness;
    }
    /// A part's motion (translation, turn times arm) in a direction by so much.
    void lead(const MovingPart& p, const Eigen::Vector3d& direction, double by, double stiffness) {
        qp_.modes.row(k_).segment(p.first, p.n()) = direction.transpose() * p.motions;
        qp_.drawn_gap[k_] = -by;
        qp_.foundation[k_++] = stiffness;
    }
    void drag(Index amplitude, double from, double stiffness) {
        qp_.modes(k_, amplitude) = 1;
        qp_.drawn_gap[k_] = -from;
        qp_.foundation[k_++] = stiffness;
    }

private:
    void side(int part, const Vec2& x, const Vec2& along) {
        if (moving_.of_part[at(part)] < 0) return;
        const MovingPart& p = moving_.list[at(moving_.of_part[at(part)])];
        qp_.modes.row(k_).segment(p.first, p.n()) += power(p, along, geometry::cross(x - p.center, along)).transpose();
    }

    const MovingParts& moving_;
    solver::ContactQp& qp_;
    Index k_ = 0;
};

}  // namespace

Eigen::Vector3d MovingPart::motion(const VectorXd& amplitudes) const {
    Eigen::Vector3d m = motions * own(amplitudes);
    m[2] /= arm;
    return m;
}

std::vector<double> sizes_of(const Scene& scene) {
    std::vector<double> sizes;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) sizes.push_back(size_of(scene, {i}));
    return sizes;
}

Bodies bodies_of(const Scene& drawn) {
    Bodies bodies{std::vector<int>(drawn.parts.size()), {}};
    std::iota(bodies.of_part.begin(), bodies.of_part.end(), 0);
    const std::vector<PairRule>& rules = drawn.contacts.pairs;
    if (std::any_of(rules.begin(), rules.end(), [](const PairRule& r) { return r.kind == PairRule::Kind::bonded; }))
        for (const Candidate& c : find_candidates_anyway(drawn, 1)) {
            if (!c.bonded) continue;
            const int one = bodies.of_part[at(c.first)], other = bodies.of_part[at(c.second)];
            std::replace(bodies.of_part.begin(), bodies.of_part.end(), std::max(one, other), std::min(one, other));
        }
    std::vector<std::vector<std::size_t>> members(drawn.parts.size());
    for (std::size_t i = 0; i < members.size(); ++i) members[at(bodies.of_part[i])].push_back(i);
    for (const int body : bodies.of_part) bodies.size.push_back(size_of(drawn, members[at(body)]));
    return bodies;
}

MovingParts moving_parts(const Scene& scene, const ResolvedConditions& conditions, const Bodies& bodies) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    ENSURE(bodies.of_part.size() == scene.parts.size(), "every part has a body");
    const std::vector<std::vector<Screw>> held = support_wrenches(scene, conditions);
    const std::vector<RigidLoad> loads = rigid_loads(scene, conditions);
    const auto members = [&](std::size_t body) {
        std::vector<std::size_t> parts;
        for (std::size_t i = body; i < scene.parts.size(); ++i)
            if (at(bodies.of_part[i]) == body) parts.push_back(i);
        return parts;
    };
    MovingParts moving;
    moving.of_part.assign(scene.parts.size(), -1);
    for (std::size_t body = 0; body < held.size(); ++body) {
        const std::vector<std::size_t> parts = members(body);
        if (parts.empty()) continue;
        MovingPart p{
            static_cast<int>(body), middle_of(scene, parts), bodies.size[body], 0.5 * bodies.size[body], {}, moving.n, {}};
        std::vector<Screw> wrenches;
        for (const std::size_t i : parts) wrenches.insert(wrenches.end(), held[i].begin(), held[i].end());
        p.motions = free_motions(wrenches, p.center, p.arm);
        if (p.n() == 0) continue;
        RigidLoad all;
        const std::size_t first = moving.list.size();
        for (const std::size_t i : parts) {
            p.part = static_cast<int>(i);
            p.load = about(p.center, loads[i], centroid(scene.parts[i].part));
            all.force += p.load.force;
            all.moment += p.load.moment;
            moving.of_part[i] = static_cast<int>(moving.list.size());
            moving.list.push_back(p);
        }
        for (std::size_t k = first; k < moving.list.size(); ++k)
            moving.list[k].pull = all.force.norm() + std::abs(all.moment) / p.arm;
        moving.n += p.n();
        moving.pull = std::max(moving.pull, moving.list[first].pull);
    }
    return moving;
}

double farthest_in_steps(const MovingParts& moving, const VectorXd& amplitudes) {
    double far = 0;
    for (const MovingPart& p : moving.list) far = std::max(far, p.own(amplitudes).norm() / (step_fraction * p.size));
    return far;
}

solver::ContactQp step_problem(const MovingParts& moving, const std::vector<ClosingRow>& gaps, const std::vector<Lead>& leads,
                               const Resisted& by, const std::vector<double>& across) {
    ENSURE(leads.size() == moving.of_part.size() && (by.turns.empty() || by.turns.size() == moving.of_part.size()),
           "what leads and turns is known of every part");
    ENSURE(by.closing > 0 && by.drag >= 0, "springs are stiff, and drags do not drive");
    double smallest = moving.list.empty() ? 1 : moving.list.front().size, pull = 0;
    const auto turn_back = [&](const MovingPart& p) { return by.turns.empty() ? 0 : by.turns[at(p.part)] + p.load.stretch; };
    const auto is_dragged_along_loads = [&](const MovingPart& p) { return by.across_loads < 1 && load_of(p).norm() > 0; };
    Index n = static_cast<Index>(gaps.size()) + std::count(by.sticks.begin(), by.sticks.end(), 1) +
              std::count_if(across.begin(), across.end(), [](double c) { return c > 0; });
    for (const MovingPart& p : moving.list) {
        n += p.n();
        smallest = std::min(smallest, p.size);
        pull += p.pull;
        for (bool is_given : leads[at(p.part)].is_given) n += is_given ? 1 : 0;
        n += turn_back(p) > 0 ? 1 : 0;
        n += is_dragged_along_loads(p) ? 1 : 0;
    }
    if (pull == 0) pull = 1;  // prescribed motions alone
    const double stiffness = pull / (by.closing * smallest);
    solver::ContactQp qp;
    qp.mode_load = VectorXd::Zero(moving.n);
    qp.load_scale = pull;
    Rows rows(moving, n, qp);
    const Eigen::Vector3d turn = Eigen::Vector3d::UnitZ();
    for (const ClosingRow& row : gaps) rows.gap(row, stiffness);
    for (std::size_t k = 0; k < by.sticks.size(); ++k)
        if (by.sticks[k]) rows.along(gaps[k], stiffness);
    for (std::size_t k = 0; k < across.size(); ++k)
        if (across[k] > 0) rows.across(gaps[k], across[k]);
    for (const MovingPart& p : moving.list) {
        const Lead& lead = leads[at(p.part)];
        const Vec2 aside = geometry::left_of(lead.axis);
        const std::array<Eigen::Vector3d, 3> directions{Eigen::Vector3d(lead.axis.x(), lead.axis.y(), 0),
                                                        Eigen::Vector3d(aside.x(), aside.y(), 0), turn};
        for (int c = 0; c < 3; ++c)
            if (lead.is_given[at(c)])
                rows.lead(p, directions[at(c)], (c == 2 ? p.arm : 1) * lead.to[c],
                          (c == lead.way ? by.leading : 1) * stiffness);
        if (const double back = turn_back(p); back > 0) rows.lead(p, turn, 0, back / (p.arm * p.arm));
        if (by.towards.size() == 0) qp.mode_load.segment(p.first, p.n()) += power(p, p.load.force, p.load.moment);
        const double own = p.pull > 0 ? p.pull : moving.pull > 0 ? moving.pull : pull;
        // along loads parts go as fast as their share of them drives them, whatever their sizes
        const double of_step = own / (step_fraction * (by.across_loads < 1 ? smallest : p.size)),
                     dragged = by.across_loads < 1 ? std::max(by.across_loads * by.drag, least_drag) : by.drag;
        if (is_dragged_along_loads(p)) rows.lead(p, load_of(p).normalized(), 0, by.drag * of_step);
        for (Index j = p.first; j < p.first + p.n(); ++j)
            rows.drag(j, by.towards.size() > 0 ? by.towards[j] : 0, dragged * of_step);
    }
    qp.gap = qp.drawn_gap;
    return qp;
}

std::vector<int> groups_of(const MovingParts& moving, const std::vector<ClosingRow>& gaps) {
    std::vector<int> group(moving.list.size());
    std::iota(group.begin(), group.end(), 0);
    for (std::size_t i = 1; i < group.size(); ++i)  // parts of one body stand side by side
        if (moving.list[i].first == moving.list[i - 1].first) group[i] = group[i - 1];
    const auto first_of = [&](int part) {
        while (group[at(part)] != part) part = group[at(part)];
        return part;
    };
    for (const ClosingRow& row : gaps) {
        const int a = moving.of_part[at(row.first)], b = moving.of_part[at(row.second)];
        if (a >= 0 && b >= 0) group[at(std::max(first_of(a), first_of(b)))] = std::min(first_of(a), first_of(b));
    }
    for (int& g : group) g = first_of(g);
    return group;
}

namespace {

/// The parts of one group, and the gaps that these have.
MovingParts only(const MovingParts& moving, const std::vector<int>& group, int number) {
    MovingParts own;
    own.of_part.assign(moving.of_part.size(), -1);
    Index of_body = -1;
    for (std::size_t i = 0; i < moving.list.size(); ++i) {
        if (group[i] != number) continue;
        own.of_part[at(moving.list[i].part)] = static_cast<int>(own.list.size());
        own.list.push_back(moving.list[i]);
        MovingPart& added = own.list.back();
        if (added.first != of_body) own.n += added.n();
        of_body = added.first;
        added.first = own.n - added.n();
        own.pull = std::max(own.pull, own.list.back().pull);
    }
    return own;
}

bool is_led(const MovingParts& moving, const std::vector<Lead>& leads) {
    return std::any_of(moving.list.begin(), moving.list.end(),
                       [&](const MovingPart& p) { return leads[at(p.part)].goes_anywhere(); });
}

/// Adds to `turns` what the forces along these gaps resist each part's turning by: the sum of force times the distance that it
/// acts from the part's middle along its own direction, which is no more than the part is large.
void add_turns(const MovingParts& moving, const std::vector<ClosingRow>& gaps, const VectorXd& force,
               std::vector<double>& turns) {
    const auto add = [&](int part, const Vec2& pivot, const Vec2& f) {
        if (moving.of_part[at(part)] < 0) return;
        const MovingPart& p = moving.list[at(moving.of_part[at(part)])];
        const double most = f.norm() * p.size;
        turns[at(part)] += std::clamp(f.dot(pivot - p.center), -most, most);
    };
    for (std::size_t k = 0; k < gaps.size(); ++k) {
        const Vec2 f = force[static_cast<Index>(k)] * gaps[k].normal;
        add(gaps[k].first, gaps[k].pivot1, -f);
        add(gaps[k].second, gaps[k].pivot2, f);
    }
}

}  // namespace

std::vector<DrivenGroup> driven_groups(const MovingParts& moving, const std::vector<ClosingRow>& gaps,
                                       const std::vector<Lead>& leads) {
    const std::vector<int> group = groups_of(moving, gaps);
    std::vector<DrivenGroup> driven;
    for (int g = 0; g < static_cast<int>(group.size()); ++g) {
        DrivenGroup own{only(moving, group, g), {}};
        if (own.moving.list.empty() || (own.moving.pull == 0 && !is_led(own.moving, leads))) continue;
        std::copy_if(gaps.begin(), gaps.end(), std::back_inserter(own.gaps), [&](const ClosingRow& row) {
            return own.moving.of_part[at(row.first)] >= 0 || own.moving.of_part[at(row.second)] >= 0;
        });
        driven.push_back(std::move(own));
    }
    return driven;
}

void put(const DrivenGroup& group, const VectorXd& amplitudes, const MovingParts& moving, VectorXd& all) {
    for (const MovingPart& p : group.moving.list)
        all.segment(moving.list[at(moving.of_part[at(p.part)])].first, p.n()) = p.own(amplitudes);
}

std::vector<double> stiffness_across(const std::vector<ClosingRow>& gaps, const VectorXd& force) {
    std::vector<double> stiffness;
    for (std::size_t k = 0; k < gaps.size(); ++k) {
        const ClosingRow& row = gaps[k];
        const double distance = (row.pivot1 - row.pivot2).dot(row.normal);
        const bool is_round = row.pivot1 != row.x1 && row.pivot2 != row.x2;
        stiffness.push_back(is_round && distance > 0 ? std::max(0.0, force[static_cast<Index>(k)]) / distance : 0);
    }
    return stiffness;
}

Step step_of(const MovingParts& moving, const std::vector<ClosingRow>& gaps, const std::vector<Lead>& leads,
             const Resisted& by) {
    Step step{VectorXd::Zero(moving.n), std::vector<double>(moving.of_part.size(), 0)};
    for (const DrivenGroup& group : driven_groups(moving, gaps, leads)) {
        const auto& [own, rows] = group;
        solver::Settled settled = settle_rigidly(step_problem(own, rows, leads, by));
        if (by.curved)
            settled = settle_rigidly(step_problem(own, rows, leads, by, stiffness_across(rows, settled.multipliers)));
        put(group, settled.amplitudes, moving, step.amplitudes);
        add_turns(own, rows, settled.multipliers, step.turns);
    }
    return step;
}

}  // namespace abut
