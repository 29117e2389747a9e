// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/settle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "solver/contact/assembly_solve.hpp"
#include "solver/contact/rigid_settle.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/contact/search_distances.hpp"
#include "src/motion/closing_rows.hpp"
#include "src/motion/friction_steps.hpp"
#include "src/motion/led_parts.hpp"
#include "src/motion/moving_parts.hpp"
#include "src/motion/relaxation.hpp"

namespace abut {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int max_steps = 600;
/// Of the smaller part's extent: overlaps that a step may leave, by the curvature of faces and the turns of parts.
constexpr double step_overlap = 0.01;
/// Likewise: more than this at the end is no rest.
constexpr double overlap_at_rest = 1e-4;
/// Of a motion: smaller digits are rounding; of a part's size: what moves less has not moved.
constexpr double rest_digits = 1e-11, moved_at_all = 1e-7;
constexpr double most_drag = 1e3;
/// Of the stiffness of gaps: what leads parts on the way gives way to gaps, and to nothing else.
constexpr double soft_lead = 1e-3;
/// Of a part's size: a push that shows whether a balance is stable; and what is unstable goes on by, at least, of the push.
constexpr double push_fraction = 1e-3, unstable_growth = 0.05;

std::string why_not_settled(const Scene& scene, const ResolvedConditions& conditions) {
    if (const std::string why = why_not_followed(scene, conditions); !why.empty()) return why;
    if (scene.parts.size() < 2) return "there is nothing to rest on";
    if (has_fits(scene.contacts)) return "fits hold parts where they are drawn";
    return "";
}

/// The way of the parts.
class Way {
public:
    Way(const Scene& drawn, const ResolvedConditions& conditions, const std::vector<Placement>& from)
        : drawn_(drawn),
          conditions_(conditions),
          rules_(drawn),
          bodies_(bodies_of(drawn)),
          placements_(from.empty() ? std::vector<Placement>(drawn.parts.size()) : from),
          sizes_(sizes_of(drawn)),
          paired_(sizes_) {
        for (const ScenePart& part : drawn.parts) centers_.push_back(centroid(part.part));
        Leads leads = leads_of(drawn, conditions);
        drawn_ = without_leads(drawn, leads);
        led_ = LedParts(std::move(leads.of), centers_, sizes_, bodies_.of_part);
        scene_ = from.empty() ? drawn_ : placed(drawn_, conditions_, from);
        find_moving();
    }

    Settling follow(bool to_the_end) {
        asks_for_end_ = to_the_end;
        if (!may_move()) {
            Settling end = rest();
            if (end.end == Settling::End::stays) end.why = "the supports hold every part that a load acts on";
            return end;
        }
        look();
        if (closing_.overlaps && is_as_drawn()) return {Settling::End::not_asked, "parts overlap where they are drawn"};
        Settling end = to_the_end || is_led_far() || goes_far(step_under(least_drag)) ? walk() : rest();
        const bool is_at_rest = end.end == Settling::End::rests || end.end == Settling::End::stays;
        return is_at_rest ? pushed(std::move(end)) : end;
    }

    /// As settle_until_held says: parts fall until they touch, roll about where they do, and slide where friction gives way;
    /// where all are held, those that are led go on.
    Settling follow_until_held(bool also_pressed) {
        look();
        if (!may_move() || (closing_.overlaps && is_as_drawn()) ||
            (!also_pressed && !is_led_far() && are_all_pressed(moving_, rolling(), leads_of_step(0), touching())))
            return {Settling::End::not_asked, "", {}, {}, ""};
        const int most_steps = max_steps + steps_led();
        for (int k = 0; k < most_steps; ++k) {
            const std::vector<ClosingRow> rows = rolling();
            const bool is_held = held_step(moving_, rows, leads_of_step(0), touching()).has_value();
            if (is_held && led_.are_there(placements_) && is_held_apart()) return rest();
            const bool goes_on = is_held && !led_.are_there(placements_);
            const std::vector<Lead> leads = leads_of_step(goes_on ? 1 : 0);
            const std::optional<VectorXd> step =
                goes_on ? led_step(moving_, rows, leads, soft_lead, touching()) : driven_step(moving_, rows, leads, touching());
            if (!step) return lost();
            if ((goes_on && led_.push_where_blocked(moving_, *step, leads, 1)) ||
                led_.end_pushes(moving_, *step, placements_)) {
                find_moving();
                continue;
            }
            VectorXd a = until_touch(moving_, rows, leads, *step, touching());
            if (farthest(a) * step_fraction <= rest_digits) return lost();
            const std::vector<double> distance = distances_to_others();
            while (!advance(a)) {
                a *= 0.5;
                if (farthest(a) < arrived_fraction) return lost();
            }
            if (const int gone = part_that_left(distance, false); gone >= 0) return never(gone);
        }
        return lost();
    }

private:
    double touching() const { return arrived_fraction * *std::min_element(sizes_.begin(), sizes_.end()); }
    std::vector<ClosingRow> rolling() const { return rolling_rows(closing_.rows, touching()); }
    /// Ends the way of parts that are led to where they are held: gaps are closed, and nothing overlaps.
    bool is_held_apart() {
        if (is_as_drawn()) return move_apart();
        if (led_.any()) end_leads();
        if (!close_up() || !move_apart()) return false;
        if (led_.any()) end_leads();
        return true;
    }
    /// Closes what is left of gaps that friction holds closed. False: it does not hold the parts as gaps close.
    bool close_up() {
        double before = std::numeric_limits<double>::infinity();
        while (true) {
            const std::optional<VectorXd> step = held_step(moving_, rolling(), leads_of_step(0), touching());
            if (!step) return false;
            const double far = farthest(*step);
            if (!(far < 0.5 * before) || !advance(*step)) return true;
            before = far;
        }
    }
    /// Moves parts out of each other, and nowhere else. False: they still overlap.
    bool move_apart() {
        constexpr int most_steps = 5;
        for (int k = 0; k < most_steps && closing_.deepest > 0; ++k)
            if (!advance(step_without_loads(VectorXd::Zero(moving_.n), 0))) break;
        return closing_.deepest <= overlap_at_rest;
    }

    bool may_move() const { return moving_.n > 0 && (moving_.pull > 0 || led_.any()); }

    bool is_led_far() const {
        const std::vector<Lead> leads = led_.left(placements_);
        for (std::size_t i = 0; i < leads.size(); ++i) {
            const auto way = [&](std::size_t c) { return leads[i].is_given[c] ? leads[i].to[static_cast<Index>(c)] : 0; };
            if (is_far({way(0), way(1)}, way(2), paired_[i])) return true;
        }
        return false;
    }

    std::vector<Lead> leads_of_step(double share) const { return led_.of_step(placements_, share, reach_); }

    /// The steps that the smallest part takes, carried as far as any is led.
    int steps_led() const {
        const double smallest = *std::min_element(sizes_.begin(), sizes_.end()),
                     steps = led_.farthest_left(placements_) / (step_fraction * smallest);
        return static_cast<int>(std::min<double>(10 * max_steps, steps));
    }

    void end_leads() {
        led_.end(placements_);
        put();
    }

    void look() {
        std::vector<double> may_move(scene_.parts.size(), 0);
        for (const MovingPart& b : moving_.list) may_move[at(b.part)] = step_fraction * b.size;
        closing_ = closing_rows(scene_, rules_, bodies_.of_part, may_move);
        for (ClosingRow& row : closing_.rows) {
            row.gap -= apart_;
            const double smaller = std::min(sizes_[at(row.first)], sizes_[at(row.second)]);
            for (const int part : {row.first, row.second}) paired_[at(part)] = std::min(paired_[at(part)], smaller);
        }
    }

    bool is_as_drawn() const {
        return std::all_of(placements_.begin(), placements_.end(), [](const Placement& p) { return p.goes_nowhere(); });
    }

    /// Is any part far from where it was drawn?
    bool is_placed() const {
        for (std::size_t i = 0; i < placements_.size(); ++i)
            if (is_far(moved(i), placements_[i].angle, paired_[i])) return true;
        return false;
    }

    /// From the present place to rest, or until it is known where it goes.
    template <class IsKnown>
    Settling walk(const IsKnown& is_known) {
        double drag = 1;
        Relaxation relaxation;
        double before = 0;
        reach_ = 1;
        for (int k = 0; k < max_steps; ++k) {
            double share = 1;
            VectorXd a = next_step(drag, share);
            if (drag <= least_drag && led_.push_where_blocked(moving_, a, leads_of_step(1), share)) {
                find_moving();
                drag = 1;
                continue;
            }
            const double far = farthest(a);
            const bool is_near = drag <= least_drag && led_.are_there(placements_) && far < 0.5 * reach_;
            if (!is_near || (far > before && !relaxation.turns_back(a))) relaxation = {};
            before = far;
            if (is_near) a = relaxation.of(a);
            if (farthest(a) > reach_) a *= reach_ / farthest(a);
            if (led_.end_pushes(moving_, a, placements_)) {
                find_moving();
                continue;
            }
            const std::vector<double> distance = distances_to_others();
            if (!advance(a)) {
                reach_ *= 0.5;
                if (reach_ < arrived_fraction) return lost();
                continue;
            }
            if (const int gone = part_that_left(distance); gone >= 0) return never(gone);
            if (is_known()) return lost();
            if (is_near && far * step_fraction <= arrived_fraction) {
                if (asks_for_end_ || is_placed() || led_.any() || closing_.deepest > overlap_at_rest) touch();
                if (closing_.deepest > overlap_at_rest) return lost();
                return rest();
            }
            if (far < 0.5 * reach_) drag = std::max(least_drag, drag * drag_step);
            reach_ = std::min(1.0, 2 * reach_);
        }
        return lost();
    }
    Settling walk() {
        return walk([] { return false; });
    }

    /// The share of a step after which the loads of some group work no more. Along finite screws their power changes: what
    /// turns about a pin goes no farther than to where its loads hang below.
    double share_driven(const VectorXd& a) const {
        const std::vector<int> group = groups_of(moving_, closing_.rows);
        double share = 1;
        for (int g = 0; g < static_cast<int>(group.size()); ++g)
            if (std::find(group.begin(), group.end(), g) != group.end()) share = std::min(share, share_driven(a, group, g));
        return share;
    }

    double share_driven(const VectorXd& a, const std::vector<int>& group, int number) const {
        const auto power = [&](double share) {
            double sum = 0;
            for (std::size_t i = 0; i < group.size(); ++i) {
                if (group[i] != number) continue;
                const MovingPart& b = moving_.list[i];
                const Eigen::Vector3d m = b.motion(a);
                sum += b.load.force.dot(Placement{share * m[2], {0, 0}}.turned(m.head<2>())) +
                       (b.load.moment - b.load.stretch * std::sin(share * m[2])) * m[2];
            }
            return sum;
        };
        double turn = 0;
        for (std::size_t i = 0; i < group.size(); ++i)
            if (group[i] == number) turn = std::max(turn, std::abs(moving_.list[i].motion(a)[2]));
        constexpr double looked_at = 1;  // radians
        const double all = turn > looked_at ? looked_at / turn : 1;
        if (power(0) <= 0 || power(all) >= 0) return all;
        constexpr int bisections = 50;
        double low = 0, high = all;
        for (int k = 0; k < bisections; ++k) (power(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
        return low;
    }

    /// At rest parts all but touch, and are not pressed into each other by the springs of the way: where they overlap by
    /// however little, faces beside a corner would be found to press.
    void touch() {
        constexpr int least_steps = 3, most_steps = 30, last_looks = 3;
        constexpr double apart = 3;                               // times what the springs are pressed by
        constexpr double least_way = 3 * apart * spring_closing;  // of a part's size: less is what they push back by
        apart_ = apart * spring_closing * *std::min_element(sizes_.begin(), sizes_.end());
        put();
        // what stops a part on the last of its way lets it go some of that; loads give way to what is prescribed
        for (int k = 0; k < last_looks; ++k) {
            const VectorXd a = step_without_loads(VectorXd::Zero(moving_.n), 1, soft_lead);
            if (led_.push_where_blocked(moving_, a, leads_of_step(1), 1, least_way))
                find_moving();
            else if (farthest(a) <= reach_)
                advance(a);
        }
        end_leads();
        leading_ = 1;
        Relaxation relaxation;
        double drag = 1;
        for (int k = 0; k < most_steps; ++k) {
            const VectorXd a = step_under(drag, 1);
            if (drag > least_drag) {
                if (farthest(a) <= reach_) advance(a);
                drag = std::max(least_drag, drag * drag_step);
                continue;
            }
            const double far = farthest(a);
            if (far <= reach_) advance(relaxation.of(a));
            if (k + 1 >= least_steps && (far > reach_ || far * step_fraction <= rest_digits)) break;
        }
        apart_ = 0;
        leading_ = soft_lead;
        end_leads();
    }

    /// The amplitudes of a step no longer than it may be; raises the drag where that takes it. Prescribed motions wait for the
    /// loads to do theirs, and then go as far as these follow: a share of what leads ask for in a step.
    VectorXd next_step(double& drag, double& share) {
        constexpr double least_share = 0.05;
        constexpr int most_raises = 8;
        share = drag <= least_drag ? 1 : 0;
        VectorXd a = step_under(drag, share, most_raises);
        for (double far = farthest(a); far > reach_ && drag < most_drag; far = farthest(a)) {
            share = share > least_share ? 0.5 * share : 0;
            if (share == 0) drag = std::min(most_drag, drag * std::clamp(far / reach_, 2.0, 100.0));
            a = step_under(drag, share, most_raises);
        }
        return a;
    }

    /// A little of every motion that the gaps closed here do not resist, as far as the other gaps let it.
    VectorXd neutral_push() const {
        const Resisted by{spring_closing, least_drag};
        const solver::ContactQp qp = step_problem(moving_, closing_.rows, leads_of_step(0), by);
        const VectorXd gap = qp.drawn_gap + qp.modes * step_of(moving_, closing_.rows, leads_of_step(0), by).amplitudes;
        const Index n = moving_.n;
        Eigen::MatrixXd resistance = Eigen::MatrixXd::Zero(n, n);
        for (Index k = 0; k < static_cast<Index>(closing_.rows.size()); ++k)
            if (gap[k] < 0) resistance += qp.modes.row(k).transpose() * qp.modes.row(k);
        const solver::SymmetricEigen eigen = solver::symmetric_eigen(resistance);
        constexpr double unlike = 0.5;  // shares, so that parts do not go along with each other
        VectorXd push = VectorXd::Zero(n);
        for (Index j = 0; j < n && eigen.values[j] < solver::neutral_motion_fraction * solver::neutral_motion_fraction; ++j)
            push += (1 - unlike * static_cast<double>(j % 2 == 0 ? j + 1 : -j) / static_cast<double>(n)) * eigen.vectors.col(j);
        const double far = farthest(push) * step_fraction;
        if (far == 0) return push;
        return step_without_loads(push * (push_fraction / far), 0);
    }

    /// Does a part that was pushed a little go on by itself, instead of back or nowhere?
    static bool goes_on(const MovingPart& b, const VectorXd& push, const VectorXd& next) {
        const VectorXd own = b.own(push);
        return own.norm() > 0.1 * push_fraction * b.size && (own + b.own(next)).norm() > (1 + unstable_growth) * own.norm();
    }

    /// A balance that a little push ends is none, where the part's own loads end it: a bar on its tip. What others press, like
    /// the discs of a column, is balanced as it was drawn.
    Settling pushed(Settling end) {
        const std::vector<Placement> before = placements_;
        const VectorXd push = neutral_push();
        if (push.norm() == 0 || !advance(push)) return end;
        const VectorXd next = step_under(least_drag);
        std::vector<char> goes(before.size(), 0);  // by part; others may follow, as a lid does whose column buckles
        for (const MovingPart& b : moving_.list) goes[at(b.part)] = goes_on(b, push, next);
        if (std::none_of(goes.begin(), goes.end(), [](char c) { return c != 0; })) return end;
        const auto way_of = [&](std::size_t i) -> Vec2 { return moved(i) - (before[i].of(centers_[i]) - centers_[i]); };
        const auto turn_of = [&](std::size_t i) { return placements_[i].angle - before[i].angle; };
        const auto has_gone = [&](std::size_t i) {
            constexpr double tipped = 1;  // radians: what leans a little against the next part is held by that
            return way_of(i).norm() > sizes_[i] || std::abs(turn_of(i)) > tipped;
        };
        const auto is_loaded = [&](std::size_t i) { return goes[i] && pull_on(i) > 0; };
        const Settling there = walk([&] {
            bool any = false, all_loaded = true;
            for (std::size_t i = 0; i < before.size(); ++i) {
                any = any || has_gone(i);
                all_loaded = all_loaded && (!is_loaded(i) || has_gone(i));
            }
            return any && all_loaded;
        });
        const bool comes_to_rest = there.end == Settling::End::rests || there.end == Settling::End::stays;
        Settling unstable{Settling::End::never, "", {}, {}, ""};
        bool is_by_own_loads = false;
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (!has_gone(i) && !(comes_to_rest && goes[i] && is_far(way_of(i), turn_of(i), sizes_[i]))) continue;
            unstable.parts.push_back(drawn_.parts[i].name);
            is_by_own_loads = is_by_own_loads || (has_gone(i) && is_loaded(i));
            unstable.why += (unstable.why.empty() ? "the balance is unstable: the least push takes " : ", ") + words(i);
        }
        if (!unstable.parts.empty() && is_by_own_loads) return unstable;
        end.unstable = unstable.why;
        return end;
    }

    /// Amplitudes of a step that the loads have no part in: as near to some motion as gaps and a share of the leads let it.
    VectorXd step_without_loads(const VectorXd& towards, double share, double leading = 1) const {
        Resisted by{spring_closing, 1, {}, towards};
        by.leading = leading;
        return settle_rigidly(step_problem(moving_, closing_.rows, leads_of_step(share), by)).amplitudes;
    }

    double pull_on(std::size_t part) const {
        const int moving = moving_.of_part[part];
        return moving < 0 ? 0 : moving_.list[at(moving)].pull;
    }

    /// Amplitudes of the step from here, with a share of what is prescribed; what no load drives stays. The drag rises until
    /// the loads drive the step to its end.
    VectorXd step_under(double drag, double share = 0, int most_raises = 0) {
        const auto step = [&] {
            Resisted by{spring_closing, drag, turns_};
            by.leading = leading_;
            by.curved = apart_ > 0;
            Step next = step_of(moving_, closing_.rows, leads_of_step(share), by);
            turns_ = std::move(next.turns);
            return next.amplitudes;
        };
        VectorXd a = step();
        if (!led_.are_there(placements_)) return a;
        for (int k = 0; k < most_raises; ++k) {
            const double driven = share_driven(a);
            if (driven == 1) return a;
            drag /= std::max(driven, drag_step);
            a = step();
        }
        return a * share_driven(a);
    }

    double farthest(const VectorXd& a) const { return farthest_in_steps(moving_, a); }

    bool goes_far(const VectorXd& a) const {
        return std::any_of(moving_.list.begin(), moving_.list.end(), [&](const MovingPart& b) {
            const Eigen::Vector3d motion = b.motion(a);
            return is_far(motion.head<2>(), motion[2], paired_[at(b.part)]);
        });
    }

    /// Takes a step, unless parts end up in each other.
    bool advance(const VectorXd& a) {
        const std::vector<Placement> before = placements_;
        const Closing closing = closing_;
        for (const MovingPart& b : moving_.list) {
            const Eigen::Vector3d motion = b.motion(a);
            Placement& p = placements_[at(b.part)];
            p = followed_by(p, b.turns_on_a_line() ? about_center(b.center, motion.head<2>(), motion[2])
                                                   : along_screw(b.center, motion.head<2>(), motion[2]));
        }
        put();
        if (closing_.deepest <= std::max(step_overlap, closing.deepest)) return true;
        placements_ = before;
        put();
        return false;
    }

    void put() {
        scene_ = placed(drawn_, conditions_, placements_);
        find_moving();
        look();
    }

    void find_moving() {
        moving_ = moving_parts(scene_, conditions_, bodies_);
        led_.act_on(moving_);
    }

    Vec2 moved(std::size_t part) const { return placements_[part].of(centers_[part]) - centers_[part]; }

    /// How far a part is from the box that holds all others.
    double distance_to_others(std::size_t part) const {
        geometry::Box2 others;
        for (std::size_t i = 0; i < scene_.parts.size(); ++i)
            if (bodies_.of_part[i] != bodies_.of_part[part]) others.extend(bounding_box(scene_.parts[i].part));
        const geometry::Box2 own = bounding_box(scene_.parts[part].part);
        return (own.min - others.max).cwiseMax(others.min - own.max).cwiseMax(0).norm();
    }

    std::vector<double> distances_to_others() const {
        std::vector<double> distances;
        for (std::size_t i = 0; i < sizes_.size(); ++i) distances.push_back(distance_to_others(i));
        return distances;
    }

    /// A part that goes away from all others or, where none rolls along another, turns all the way round.
    int part_that_left(const std::vector<double>& distance, bool none_rolls = true) const {
        for (const MovingPart& b : moving_.list) {
            const std::size_t i = at(b.part);
            if (led_.has_way(i)) continue;
            const double now = distance_to_others(i);
            const bool has_turned = none_rolls && std::abs(placements_[i].angle) > 2 * std::numbers::pi;
            if ((now > b.size && now > distance[i]) || has_turned) return b.part;
        }
        return -1;
    }

    std::string words(std::size_t part) const {
        return placement_text(drawn_.parts[part].name, placements_[part], centers_[part], sizes_[part]);
    }

    Settling never(int part) const {
        return {Settling::End::never,
                words(at(part)) + ", away from all others, and nothing stops it before",
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
            const std::size_t body = at(bodies_.of_part[i]);
            const bool is_rounding =
                moved(body).norm() + sizes_[body] * std::abs(placements_[body].angle) < moved_at_all * sizes_[body];
            settling.placements.push_back(is_rounding ? Placement{}
                                          : led_.is_led(i)
                                              ? placements_[i]
                                              : without_rounding(placements_[body], centers_[body], sizes_[body], rest_digits));
            if (!is_far(moved(i), placements_[i].angle, paired_[i])) continue;
            settling.parts.push_back(drawn_.parts[i].name);
            settling.why += (settling.why.empty() ? "" : ", ") + words(i);
        }
        if (settling.parts.empty()) {
            settling.end = Settling::End::stays;
            settling.why = "no part goes far from where it is drawn";
        }
        return settling;
    }

    Scene drawn_;  // with supports that lead no more
    const ResolvedConditions& conditions_;
    PairRules rules_;
    Bodies bodies_;
    std::vector<Placement> placements_;
    Scene scene_;  // with the parts there
    std::vector<double> sizes_;
    std::vector<double> paired_;  // by part: the least size of it and what it came near to
    std::vector<Vec2> centers_;   // as drawn
    LedParts led_{{}, {}, {}, {}};
    MovingParts moving_;
    Closing closing_;
    bool asks_for_end_ = false;  // also where no part goes far
    double reach_ = 1;           // of a step
    std::vector<double> turns_;  // what forces of the last step resist turns by
    double apart_ = 0;
    double leading_ = soft_lead;
};

/// follow: a way, to its end.
template <class Follow>
Settling settle_about_middle(const Scene& drawn, const ResolvedConditions& conditions, const std::vector<Placement>& from,
                             const Follow& follow) {
    const std::optional<Vec2> middle = far_middle(drawn);
    if (!middle) return follow(Way(drawn, conditions, from));
    std::vector<Placement> about_middle = from;
    for (Placement& p : about_middle) p.shift += p.turned(*middle) - *middle;
    Settling settling = follow(Way(shifted(drawn, conditions, -*middle), conditions, about_middle));
    for (Placement& p : settling.placements) p.shift += *middle - p.turned(*middle);
    return settling;
}

}  // namespace

Settling settle(const Scene& drawn, const ResolvedConditions& conditions, const std::vector<Placement>& from, bool to_the_end) {
    ENSURE(is_resolved(drawn, conditions), "conditions are resolved for this scene");
    ENSURE(from.empty() || from.size() == drawn.parts.size(), "every part has a place before, or none has");
    if (const std::string why = why_not_settled(drawn, conditions); !why.empty()) return {Settling::End::not_asked, why};
    if (has_friction(drawn.contacts)) return {Settling::End::not_asked, "friction may hold parts where they are drawn"};
    return settle_about_middle(drawn, conditions, from, [&](Way&& way) { return way.follow(to_the_end); });
}

Settling settle_until_held(const Scene& drawn, const ResolvedConditions& conditions, bool also_pressed) {
    ENSURE(is_resolved(drawn, conditions), "conditions are resolved for this scene");
    if (const std::string why = why_not_settled(drawn, conditions); !why.empty()) return {Settling::End::not_asked, why};
    return settle_about_middle(drawn, conditions, {}, [&](Way&& way) { return way.follow_until_held(also_pressed); });
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
