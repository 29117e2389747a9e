// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/settle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/contact/assembly_solve.hpp"
#include "solver/contact/rigid_settle.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "src/base/index.hpp"
#include "src/motion/closing_rows.hpp"
#include "src/motion/moving_parts.hpp"

namespace abut {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int max_steps = 300;
/// Of the smaller part's extent: overlaps that a step may leave, by the curvature of faces and the turns of parts.
constexpr double step_overlap = 0.01;
/// Of the smallest part's size: how far the loads press the springs along the gaps together, on the way and at rest.
constexpr double spring_closing = 1e-5, closing_at_rest = 1e-8;
/// Of a motion: smaller digits are the rounding of these springs.
constexpr double rest_digits = 1e-7;
/// Of a part's loads: what drives it less is the rounding of drawings, and holds as balanced. The drag is that of the loads
/// over a step's length times a factor between this and one.
constexpr double least_drag = 1e-6, drag_step = 1e-2, most_drag = 1e3;
/// Of a part's size: a step that goes less far ends the search, and so do some steps under the least drag.
constexpr double settled = 1e-4;
constexpr int last_steps = 10;
/// Of a part's size: a push that shows whether a balance is stable; and what is unstable goes on by, at least, of the push.
constexpr double push_fraction = 1e-3, unstable_growth = 0.05;

bool has_friction(const ContactOptions& contacts) {
    return contacts.friction > 0 || std::any_of(contacts.pairs.begin(), contacts.pairs.end(),
                                                [](const PairRule& r) { return r.friction.value_or(0) > 0; });
}

bool has_fits(const ContactOptions& contacts) {
    return contacts.overlap != "report" ||
           std::any_of(contacts.pairs.begin(), contacts.pairs.end(), [](const PairRule& r) { return r.interference != 0; });
}

std::string why_not_settled(const Scene& scene) {
    if (const std::string why = why_not_followed(scene); !why.empty()) return why;
    if (scene.parts.size() < 2) return "there is nothing to rest on";
    if (has_friction(scene.contacts)) return "friction may hold parts where they are drawn";
    if (has_fits(scene.contacts)) return "fits hold parts where they are drawn";
    return "";
}

/// The way of the parts.
class Way {
public:
    Way(const Scene& drawn, const ResolvedConditions& conditions)
        : drawn_(drawn), conditions_(conditions), rules_(drawn), placements_(drawn.parts.size()), leads_(drawn.parts.size()) {
        for (const ScenePart& part : drawn.parts) {
            sizes_.push_back(bounding_box(part.part).diagonal());
            centers_.push_back(centroid(part.part));
        }
        for (Support& s : drawn_.supports)
            if (is_led_far(drawn_, s)) take_lead(s);
        scene_ = drawn_;
        moving_ = moving_parts(scene_, conditions_, sizes_);
    }

    bool may_move() const { return moving_.n > 0 && (moving_.pull > 0 || is_led()); }

    Settling follow() {
        look();
        if (closing_.deepest > 0) return {Settling::End::not_asked, "parts overlap where they are drawn"};
        Settling end = !is_where_led() || goes_far(step_under(least_drag)) ? walk() : rest();
        const bool is_at_rest = end.end == Settling::End::rests || end.end == Settling::End::stays;
        return is_at_rest ? pushed(std::move(end)) : end;
    }

private:
    /// The support leads its part instead of holding it.
    void take_lead(Support& s) {
        for (std::size_t i = 0; i < drawn_.parts.size(); ++i) {
            if (drawn_.parts[i].name != s.part) continue;
            const std::array<std::optional<double>*, 3> given{&s.rigid_x, &s.rigid_y, &s.rigid_rotation};
            for (std::size_t c = 0; c < 3; ++c) {
                if (!*given[c]) continue;
                leads_[i].is_given[c] = true;
                leads_[i].left[static_cast<Index>(c)] = **given[c];
                given[c]->reset();
            }
        }
    }

    bool is_led() const {
        return std::any_of(leads_.begin(), leads_.end(), [](const Lead& lead) { return lead.left.norm() > 0; });
    }

    /// What is still to come of the prescribed motions.
    std::vector<Lead> leads_from_here() const {
        std::vector<Lead> leads = leads_;
        for (std::size_t i = 0; i < leads.size(); ++i)
            leads[i].left -= Eigen::Vector3d(moved(i).x(), moved(i).y(), placements_[i].angle);
        return leads;
    }

    /// A share of the same, no farther than a step may go.
    std::vector<Lead> leads_of_step(double share) const {
        std::vector<Lead> leads = leads_from_here();
        for (std::size_t i = 0; i < leads.size(); ++i)
            leads[i].left *= share / std::max(1.0, steps_to(leads[i], sizes_[i]) / reach_);
        return leads;
    }

    static double steps_to(const Lead& lead, double size) {
        Eigen::Vector3d way = lead.left;
        way[2] *= 0.5 * size;
        for (std::size_t c = 0; c < 3; ++c)
            if (!lead.is_given[c]) way[static_cast<Index>(c)] = 0;
        constexpr double within = 0.9;
        return way.norm() / (within * step_fraction * size);
    }

    /// Prescribed motions are met exactly.
    void end_lead(std::size_t part) {
        const auto& [is_given, to] = leads_[part];
        const Vec2 by(is_given[0] ? to[0] : moved(part).x(), is_given[1] ? to[1] : moved(part).y());
        if (is_given[0] || is_given[1] || is_given[2])
            placements_[part] = about_center(centers_[part], by, is_given[2] ? to[2] : placements_[part].angle);
    }

    bool is_where_led() const {
        const std::vector<Lead> leads = leads_from_here();
        for (std::size_t i = 0; i < leads.size(); ++i)
            if (steps_to(leads[i], sizes_[i]) * step_fraction > settled) return false;
        return true;
    }

    void look() {
        std::vector<double> may_move(scene_.parts.size(), 0);
        for (const MovingPart& b : moving_.list) may_move[at(b.part)] = step_fraction * b.size;
        closing_ = closing_rows(scene_, rules_, may_move);
        for (ClosingRow& row : closing_.rows) row.gap -= apart_;
    }

    /// From the present place to rest.
    Settling walk() {
        double drag = 1;
        int under_least = 0;
        reach_ = 1;
        for (int k = 0; k < max_steps; ++k) {
            VectorXd a = next_step(drag);
            if (farthest(a) > reach_) a *= reach_ / farthest(a);
            if (!advance(a)) {
                reach_ *= 0.5;
                if (reach_ < settled) return lost();
                continue;
            }
            if (const int gone = part_that_left(); gone >= 0) return never(gone);
            const bool is_least = drag <= least_drag && is_where_led();
            under_least += is_least ? 1 : 0;
            if (is_least && (farthest(a) * step_fraction <= settled || under_least >= last_steps)) {
                touch();
                return rest();
            }
            if (farthest(a) < 0.5 * reach_) drag = std::max(least_drag, drag * drag_step);
            reach_ = std::min(1.0, 2 * reach_);
        }
        return lost();
    }

    /// At rest parts all but touch, and are not pressed into each other by the springs of the way: where they overlap by
    /// however little, faces beside a corner would be found to press.
    void touch() {
        constexpr int steps = 3;
        constexpr double apart = 3;  // times what the springs are pressed by
        spring_closing_ = closing_at_rest;
        apart_ = apart * closing_at_rest * *std::min_element(sizes_.begin(), sizes_.end());
        for (std::size_t i = 0; i < placements_.size(); ++i) end_lead(i);
        put();
        for (int k = 0; k < steps; ++k)
            if (const VectorXd a = step_under(least_drag); farthest(a) <= reach_) advance(a);
        spring_closing_ = spring_closing;
        apart_ = 0;
    }

    /// The amplitudes of a step no longer than it may be; raises the drag where that takes it. Prescribed motions wait for the
    /// loads to do theirs, and then go as far as these follow.
    VectorXd next_step(double& drag) const {
        constexpr double least_share = 0.05;
        double share = drag <= least_drag ? 1 : 0;
        VectorXd a = step_under(drag, share);
        for (double far = farthest(a); far > reach_ && drag < most_drag; far = farthest(a)) {
            share = share > least_share ? 0.5 * share : 0;
            if (share == 0) drag = std::min(most_drag, drag * std::clamp(far / reach_, 2.0, 100.0));
            a = step_under(drag, share);
        }
        return a;
    }

    /// A little of every motion that the gaps closed here do not resist.
    VectorXd neutral_push() const {
        const solver::ContactQp qp = step_problem(moving_, closing_.rows, leads_of_step(0), {closing_at_rest, least_drag});
        const VectorXd gap = qp.drawn_gap + qp.modes * settle_rigidly(qp).amplitudes;
        const Index n = moving_.n;
        Eigen::MatrixXd resistance = Eigen::MatrixXd::Zero(n, n);
        for (Index k = 0; k < static_cast<Index>(closing_.rows.size()); ++k)
            if (gap[k] < 0) resistance += qp.modes.row(k).transpose() * qp.modes.row(k);
        const solver::SymmetricEigen eigen = solver::symmetric_eigen(resistance);
        VectorXd push = VectorXd::Zero(n);
        for (Index j = 0; j < n && eigen.values[j] < solver::neutral_motion_fraction * solver::neutral_motion_fraction; ++j)
            push += eigen.vectors.col(j);
        const double far = farthest(push) * step_fraction;
        return far > 0 ? VectorXd(push * (push_fraction / far)) : push;
    }

    /// Does what was pushed a little go on by itself?
    bool goes_on(const VectorXd& push, const VectorXd& next) const {
        return std::any_of(moving_.list.begin(), moving_.list.end(), [&](const MovingPart& b) {
            const VectorXd own = b.own(push);
            return own.norm() > 0.1 * push_fraction * b.size && own.dot(b.own(next)) > unstable_growth * own.squaredNorm();
        });
    }

    /// A balance that a little push ends is none, where the part's own loads end it: a bar on its tip. What others press, like
    /// the discs of a column, is balanced as it was drawn.
    Settling pushed(Settling end) {
        const std::vector<Placement> before = placements_;
        const VectorXd push = neutral_push();
        if (push.norm() == 0 || !advance(push) || !goes_on(push, step_under(least_drag))) return end;
        walk();
        Settling unstable{Settling::End::never, "", {}, {}, ""};
        bool is_by_own_loads = false;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Vec2 by = moved(i) - (before[i].of(centers_[i]) - centers_[i]);
            constexpr double tipped = 1;  // radians: what leans a little against the next part is held by that
            if (by.norm() <= sizes_[i] && std::abs(placements_[i].angle - before[i].angle) <= tipped) continue;
            unstable.parts.push_back(drawn_.parts[i].name);
            is_by_own_loads = is_by_own_loads || pull_on(i) > 0;
            unstable.why += (unstable.why.empty() ? "the balance is unstable: the least push takes " : ", ") + words(i);
        }
        if (!unstable.parts.empty() && is_by_own_loads) return unstable;
        end.unstable = unstable.why;
        return end;
    }

    double pull_on(std::size_t part) const {
        const int moving = moving_.of_part[part];
        return moving < 0 ? 0 : moving_.list[at(moving)].pull;
    }

    /// Amplitudes of the step from here, with a share of what is prescribed; what no load drives stays.
    VectorXd step_under(double drag, double share = 0) const {
        return settle_rigidly(step_problem(moving_, closing_.rows, leads_of_step(share), {spring_closing_, drag})).amplitudes;
    }

    /// The longest motion, in steps' lengths.
    double farthest(const VectorXd& a) const {
        double far = 0;
        for (const MovingPart& b : moving_.list) far = std::max(far, b.own(a).norm() / (step_fraction * b.size));
        return far;
    }

    bool goes_far(const VectorXd& a) const {
        return std::any_of(moving_.list.begin(), moving_.list.end(), [&](const MovingPart& b) {
            const Eigen::Vector3d motion = b.motion(a);
            return is_far(motion.head<2>(), motion[2], b.size);
        });
    }

    /// Takes a step, unless parts end up in each other.
    bool advance(const VectorXd& a) {
        const std::vector<Placement> before = placements_;
        const Closing closing = closing_;
        for (const MovingPart& b : moving_.list) {
            const Eigen::Vector3d motion = b.motion(a);
            Placement& p = placements_[at(b.part)];
            p = followed_by(p, along_screw(b.center, motion.head<2>(), motion[2]));
        }
        put();
        if (closing_.deepest <= std::max(step_overlap, closing.deepest)) return true;
        placements_ = before;
        put();
        return false;
    }

    void put() {
        scene_ = placed(drawn_, conditions_, placements_);
        moving_ = moving_parts(scene_, conditions_, sizes_);
        look();
    }

    Vec2 moved(std::size_t part) const { return placements_[part].of(centers_[part]) - centers_[part]; }

    /// Is the part drawn within the box of another: in its hole, or between its walls?
    bool is_in_another(std::size_t part) const {
        const geometry::Box2 own = bounding_box(drawn_.parts[part].part);
        for (std::size_t i = 0; i < drawn_.parts.size(); ++i)
            if (i != part && own.is_within(bounding_box(drawn_.parts[i].part), 0)) return true;
        return false;
    }

    /// A part that goes farther than its own size (where another surrounds it, than the other's), or turns half around.
    int part_that_left() const {
        for (const MovingPart& b : moving_.list) {
            const std::size_t i = at(b.part);
            if (steps_to(leads_[i], b.size) > 0) continue;
            const double most = is_in_another(i) ? *std::max_element(sizes_.begin(), sizes_.end()) : b.size;
            if (moved(i).norm() > most || std::abs(placements_[i].angle) > std::numbers::pi) return b.part;
        }
        return -1;
    }

    std::string words(std::size_t part) const {
        return placement_text(drawn_.parts[part].name, placements_[part], centers_[part], sizes_[part]);
    }

    Settling never(int part) const {
        return {Settling::End::never,
                words(at(part)) + ", farther than its own size, and nothing stops it before",
                {},
                {drawn_.parts[at(part)].name},
                ""};
    }

    Settling lost() const {
        return {Settling::End::lost, "no place of rest was found in " + std::to_string(max_steps) + " steps", {}, {}, ""};
    }

    Settling rest() {
        Settling settling{Settling::End::rests, "", {}, {}, ""};
        for (std::size_t i = 0; i < placements_.size(); ++i) {
            const bool is_rounding = moved(i).norm() + sizes_[i] * std::abs(placements_[i].angle) < rest_digits * sizes_[i];
            settling.placements.push_back(is_rounding ? Placement{}
                                                      : without_rounding(placements_[i], centers_[i], sizes_[i], rest_digits));
            if (!is_far(moved(i), placements_[i].angle, sizes_[i])) continue;
            settling.parts.push_back(drawn_.parts[i].name);
            settling.why += (settling.why.empty() ? "" : ", ") + words(i);
        }
        if (settling.parts.empty()) return {Settling::End::stays, "no part goes far from where it is drawn", {}, {}, ""};
        return settling;
    }

    Scene drawn_;  // with supports that lead no more
    const ResolvedConditions& conditions_;
    PairRules rules_;
    std::vector<Placement> placements_;
    std::vector<Lead> leads_;  // from where parts are drawn
    Scene scene_;              // with the parts there
    std::vector<double> sizes_;
    std::vector<Vec2> centers_;  // as drawn
    MovingParts moving_;
    Closing closing_;
    double reach_ = 1;  // of a step
    double spring_closing_ = spring_closing, apart_ = 0;
};

}  // namespace

Settling settle(const Scene& drawn, const ResolvedConditions& conditions) {
    if (const std::string why = why_not_settled(drawn); !why.empty()) return {Settling::End::not_asked, why};
    Way way(drawn, conditions);
    if (!way.may_move()) return {Settling::End::stays, "the supports hold every part that a load acts on"};
    return way.follow();
}

Effect large_motion_effect(const Settling& settling) {
    Effect effect;
    effect.name = "large motion";
    effect.on = settling.end == Settling::End::rests;
    effect.parts = settling.end == Settling::End::rests ? settling.parts : std::vector<std::string>{};
    effect.why = settling.why;
    if (effect.on) effect.why = "parts are analysed where the loads take them: " + settling.why;
    if (settling.end == Settling::End::never) effect.why = "no place of rest: " + settling.why;
    return effect;
}

}  // namespace abut
