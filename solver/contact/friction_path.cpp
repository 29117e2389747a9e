// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/friction_path.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "solver/contact/condensation.hpp"
#include "solver/contact/friction_states.hpp"
#include "solver/contact/kept_states.hpp"
#include "solver/linear_algebra/nonnegative.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Increments down to a thousandth of the path: what touches within one sticks to within that of its way. Answers that are not
/// found on a sixteenth are not found.
constexpr int most_halvings = 10, most_halvings_to_answer = 4;
/// Where bodies roll and slide until others hold them searches take hundreds of steps: after so many increments are halved no
/// more.
constexpr int most_steps = 10000;
/// Of the path: changes in shorter increments need be no smaller. Contacts that close change tractions in proportion to the
/// increment, in which only few do.
constexpr double share_at_least = 1.0 / 16;
constexpr double open_force = 1e-10;  // of the loads

/// Where the path has come to.
struct State {
    VectorXd forces;            ///< multipliers
    VectorXd gap, slipped;      ///< of pressures' rows, and of tangential ones since the start; of others nothing
    VectorXd closing, passing;  ///< what these change by along the whole path, as they did last; empty: not known
    bool is_followed = false;   ///< else they are what loads alone would do
};

/// An increment: slips count from where the bodies are as it begins, but where they touch in it from where they are then.
struct Increment {
    VectorXd from;  ///< tangential opening, by row
    HeldAnswer answer;
    bool has_answer() const { return answer.has_answer() && answer.result.mechanism.size() == 0; }
    const VectorXd& forces() const { return answer.result.multipliers; }
};

/// The rows of a face's pressure.
struct Face {
    Index begin, size;
};

/// Friction's rows come face by face.
std::vector<Face> faces_of(const std::vector<FrictionRow>& friction) {
    std::vector<Face> faces;
    for (const FrictionRow& f : friction)
        if (!faces.empty() && f.normal == faces.back().begin + faces.back().size)
            ++faces.back().size;
        else
            faces.push_back({f.normal, 1});
    return faces;
}

/// Takes amplitudes of all motions into the gaps.
void move_bodies(const VectorXd& amplitudes, ContactQp& qp) {
    const VectorXd opened = qp.modes * amplitudes;
    qp.gap += opened;
    qp.drawn_gap += opened;
}

/// Motions that only contact resists, by which bodies give way.
class GivingWay {
public:
    explicit GivingWay(const ContactQp& qp) {
        std::vector<char> is_tangential(qp.unilateral.size(), 0);
        for (const FrictionRow& f : qp.friction) is_tangential[static_cast<std::size_t>(f.tangential)] = 1;
        std::vector<Index> held;
        for (std::size_t k = 0; k < is_tangential.size(); ++k)
            if (qp.unilateral[k])
                rows_.push_back(static_cast<Index>(k));
            else if (!is_tangential[k])
                held.push_back(static_cast<Index>(k));
        HeldMotions of_held(qp);
        for (const Index row : held) of_held.hold(row);
        const auto basis = of_held.basis();
        free_ = MatrixXd::Identity(qp.modes.cols(), qp.modes.cols()) - basis * basis.transpose();
        moved_ = qp.modes * free_;
        is_possible_ = !moved_.isZero(0) && !rows_.empty();
    }
    bool is_possible() const { return is_possible_; }
    /// The least amplitudes such that no gap is negative; empty: there are none.
    VectorXd least(const VectorXd& gap) const {
        const std::optional<VectorXd> least = least_distance(moved_(rows_, Eigen::all), -gap(rows_));
        return least ? VectorXd(free_ * *least) : VectorXd(0);
    }

private:
    std::vector<Index> rows_;  ///< of pressures
    MatrixXd free_, moved_;    ///< projection onto these motions; what rows move by in them
    bool is_possible_ = false;
};

class Path {
public:
    Path(const ContactQp& qp, const PathStart& start, const VectorXd& weight, const MotionSplit& split, const MatrixXd& levers,
         std::optional<double> tolerance)
        : qp_(qp),
          start_(start),
          weight_(weight),
          split_(split),
          levers_(levers),
          tolerance_(tolerance.value_or(0)),
          is_at_once_(!tolerance),
          faces_(faces_of(qp.friction)) {}

    FrictionPath follow() {
        const VectorXd none = VectorXd::Zero(qp_.gap.size());
        State begin{none, start_.gap, none, {}, {}};
        from_ = go_as_unpressed(begin);
        if (from_ == 1) return without_contact();
        const Increment at_once = solve(begin, from_, 1, qp_.expected);
        path_.emplace(FrictionPath{at_once.answer, {0, none, none, none}});
        bool is_found = false, is_sought = false;
        if (is_at_once_) return finished();
        if (const ContactQpResult& r = at_once.answer.result; r.feasible && r.mechanism.size() == 0) {
            if (start_.is_loaded && from_ == 0)
                if (const Increment there = solve(begin, 0, 0, expected_from(at_once)); there.has_answer())
                    begin.forces = there.forces();
            approach_ = start_.gap - r.gap;
            scale_ = std::max(norm_of_pressure(begin.forces), norm_of_pressure(r.multipliers));
            const bool is_open = at_once.has_answer() && !is_pressed(begin.forces) && !is_pressed(r.multipliers);
            is_sought = !is_open;
            if (const double rest = is_sought && from_ == 0 ? fall(begin, at_once) : 0; rest > 0)
                is_found = advance(begin, rest, 1, solve(begin, rest, 1, at_once.forces()), 0).has_value();
            else
                is_found = is_sought && advance(begin, from_, 1, at_once, 0).has_value();
        }
        if (!is_found) path_.emplace(FrictionPath{at_once.answer, {1, none, none, none, at_once.has_answer() && is_sought}});
        return finished();
    }

private:
    FrictionPath finished() {
        path_->iterations = iterations_;
        return std::move(*path_);
    }

    /// Where bodies can give way to the end nothing presses.
    FrictionPath without_contact() {
        const VectorXd none = VectorXd::Zero(qp_.gap.size());
        constexpr double rounding = 1e-9;  // of gaps: what is just touched is not pressed by them
        ContactQp qp = at(1);
        move_bodies(given_way_, qp);
        const double margin = rounding * qp.gap.cwiseAbs().maxCoeff();
        for (const FrictionRow& f : qp_.friction) qp.gap[f.normal] += margin;
        path_.emplace(FrictionPath{solve_held(qp, split_, levers_), {1, none, none, none}});
        path_->moved = given_way_;
        iterations_ += path_->end.result.iterations;
        return finished();
    }

    /// Bodies go where the loads take them until they touch. Those that nothing holds give way to others as long as they can,
    /// without friction, since nothing presses until then: how far on the path that is.
    double go_as_unpressed(State& begin) {
        const auto is_open = [&](const FrictionRow& f) { return start_.gap[f.normal] > 0; };
        if (std::none_of(qp_.friction.begin(), qp_.friction.end(), is_open)) return 0;
        const std::optional<VectorXd> there = unpressed(0), here = unpressed(1);
        if (!there || !here) return 0;
        begin.gap = *there;
        double from = 0;
        VectorXd moved = VectorXd::Zero(begin.gap.size());
        if (const GivingWay way(qp_); way.is_possible() && closes(*here) && way.least(*there).size() > 0) {
            constexpr int bisections = 20;
            given_way_ = way.least(*here);
            if (given_way_.size() > 0) return 1;
            double to = 1;
            for (int k = 0; k < bisections; ++k) {
                const double middle = 0.5 * (from + to);
                const VectorXd least = way.least((1 - middle) * *there + middle * *here);
                (least.size() > 0 ? from : to) = middle;
                if (least.size() > 0) moved = qp_.modes * least;
            }
            begin.gap = (1 - from) * *there + from * *here + moved;
            if (from > 0)
                for (const FrictionRow& f : qp_.friction) begin.slipped[f.tangential] = begin.gap[f.tangential];
        }
        begin.closing = (begin.gap - (*here + moved)) / (1 - from);
        begin.passing = -begin.closing;
        return from;
    }

    bool closes(const VectorXd& gap) const {
        return std::any_of(qp_.friction.begin(), qp_.friction.end(), [&](const FrictionRow& f) { return gap[f.normal] < 0; });
    }

    /// The gaps at a place of the path where no contact carries anything; nothing: loads drive bodies that nothing holds then.
    std::optional<VectorXd> unpressed(double end) const {
        ContactQp qp = at(end);
        if (qp.mode_load.norm() <= open_force * qp.load_scale) qp.mode_load.setZero();
        ActiveSet open = bilateral_rows(qp);
        for (const FrictionRow& f : qp.friction) open[static_cast<std::size_t>(f.tangential)] = row_state::open;
        ContactState state;
        if (!state_with_friction(qp, open, state)) return std::nullopt;
        return gap_of({qp, qp.gap}, state);
    }

    ContactQp at(double end) const {
        ContactQp qp = qp_;
        qp.kept = kept_;
        qp.gap = (1 - end) * start_.gap + end * qp_.gap;
        qp.mode_load = (1 - end) * start_.mode_load + end * qp_.mode_load;
        return qp;
    }

    /// expected: multipliers under the same loads, or others.
    Increment solve(const State& from, double begin, double end, const VectorXd& expected) {
        ContactQp qp = at(end);
        VectorXd origin = touching(from, end - begin);
        qp.gap -= origin;
        qp.drawn_gap -= origin;
        qp.expected = expected;
        qp.asks_holding_factor = begin == from_ && end == 1;
        Increment increment{std::move(origin), solve_held(qp, split_, levers_)};
        iterations_ += increment.answer.result.iterations;
        return increment;
    }

    /// Bodies that nothing holds come to rest on others under any load at all, in no proportion to it: within the least
    /// increment. Where that ends, and the state there; 0: nothing does so.
    double fall(State& state, const Increment& at_once) {
        if (!at_once.has_answer() || !closes_from_afar(state, at_once.forces())) return 0;
        const double size = std::ldexp(1, -most_halvings);
        const Increment least = solve(state, 0, size, at_once.forces());
        if (!least.has_answer() || !closes_from_afar(state, least.forces())) return 0;
        const VectorXd none = VectorXd::Zero(qp_.gap.size());
        take(least, none, work_of(state, least), none, 1);
        state = after(state, least, size);
        state.closing = state.passing = VectorXd(0);
        state.is_followed = false;
        return size;
    }

    const VectorXd& expected_from(const Increment& increment) const {
        return increment.has_answer() ? increment.forces() : qp_.expected;
    }

    /// The tangential openings that slips of an increment count from. What is open goes on as it did, until it touches.
    VectorXd touching(const State& from, double size) const {
        VectorXd origin = from.slipped;
        if (from.closing.size() == 0) return origin;
        for (const FrictionRow& f : qp_.friction) {
            const double closing = from.closing[f.normal];
            if (from.forces[f.normal] > 0 || !(closing > 0)) continue;
            origin[f.tangential] += from.passing[f.tangential] * std::clamp(from.gap[f.normal] / closing, 0.0, size);
        }
        return origin;
    }

    /// The states but of faces' rows that carry nothing beyond rounding: what is just touched is not held.
    ActiveSet carrying(const ContactQpResult& r) const {
        ActiveSet states = r.active;
        for (const FrictionRow& f : qp_.friction)
            if (!(r.multipliers[f.normal] > open_force * qp_.load_scale))
                states[static_cast<std::size_t>(f.normal)] = states[static_cast<std::size_t>(f.tangential)] = row_state::open;
        return states;
    }

    /// Bodies that nothing holds yet stay, but for what their loads alone do: where a search has put them says nothing.
    State after(const State& from, const Increment& increment, double size) const {
        const ContactQpResult& r = increment.answer.result;
        const ContactQp& qp = increment.answer.qp;
        VectorXd gap = r.gap;
        if (qp.modes.cols() > 0) gap -= qp.modes * held_motions(qp, carrying(r)).free_part(r.amplitudes());
        State state{increment.forces(), gap, increment.from, {}, {}, true};
        for (const FrictionRow& f : qp_.friction) state.slipped[f.tangential] += gap[f.tangential];
        state.closing = (from.gap - state.gap) / size;
        state.passing = (state.slipped - from.slipped) / size;
        return state;
    }

    /// Tractions in the mean over an increment, as what slips all the way has them: at their bound, which grows or falls evenly
    /// with the pressure. What sticks has no slip to work against.
    VectorXd work_of(const State& from, const Increment& increment) const {
        VectorXd work = VectorXd::Zero(qp_.gap.size());
        for (const FrictionRow& f : qp_.friction)
            if (const double now = increment.forces()[f.normal]; now > 0)
                work[f.tangential] = -0.5 * (1 + std::max(0.0, from.forces[f.normal]) / now) *
                                     increment.forces()[f.tangential] * increment.answer.result.gap[f.tangential];
        return work;
    }

    /// By more than rounding. Between loads under which nothing presses nothing does.
    bool is_pressed(const VectorXd& forces) const {
        double sum = 0;
        for (const FrictionRow& f : qp_.friction) sum += std::max(0.0, forces[f.normal]);
        return sum > open_force * qp_.load_scale;
    }

    /// Does a face come into contact from a distance, of which nothing is known yet? Before it touches its bodies may move
    /// along each other.
    bool closes_from_afar(const State& from, const VectorXd& forces) const {
        return !from.is_followed && std::any_of(faces_.begin(), faces_.end(), [&](const Face& f) {
            return forces.segment(f.begin, f.size).maxCoeff() > 0 && !(from.forces.segment(f.begin, f.size).maxCoeff() > 0) &&
                   from.gap.segment(f.begin, f.size).minCoeff() > tolerance_ * approach_.segment(f.begin, f.size).maxCoeff();
        });
    }

    double norm_of_pressure(const VectorXd& forces) const {
        double square = 0;
        for (const FrictionRow& f : qp_.friction) square += forces[f.normal] * forces[f.normal] / weight_[f.normal];
        return std::sqrt(square);
    }
    double norm_of_change(const VectorXd& forces) const {
        double square = 0;
        for (const FrictionRow& f : qp_.friction) {
            const double traction = forces[f.tangential] / std::min(1.0, f.coefficient);
            square += traction * traction / weight_[f.tangential];
        }
        return std::max(norm_of_pressure(forces), std::sqrt(square));
    }

    void take(const Increment& increment, const VectorXd& error, const VectorXd& work, const VectorXd& work_error, int n) {
        path_->way.error += error;
        path_->way.work += work;
        path_->way.work_error += work_error;
        path_->way.increments += n;
        path_->end = increment.answer;
    }

    /// From a state at `begin` to `end`; at_once: as one increment. The state there; nothing: it was not found.
    std::optional<State> advance(const State& from, double begin, double end, const Increment& at_once, int level) {
        const double half = 0.5 * (end - begin), middle = begin + half;
        const bool has_whole = at_once.has_answer();
        const Increment first = solve(from, begin, middle, expected_from(at_once));
        if (!first.has_answer() && (has_whole || level >= most_halvings_to_answer))
            return take_unchecked(from, at_once, 2 * half);
        VectorXd expected = expected_from(at_once);
        const State halfway = first.has_answer() ? after(from, first, half) : from;
        if (has_whole) {
            const Increment second = solve(halfway, middle, end, expected);
            if (!second.has_answer()) return take_unchecked(from, at_once, 2 * half);
            const VectorXd change = second.forces() - at_once.forces();
            const bool is_near = norm_of_change(change) <= tolerance_ * std::max(2 * half, share_at_least) * scale_;
            if (level == most_halvings || iterations_ >= most_steps || (is_near && !closes_from_afar(from, second.forces()))) {
                const VectorXd work = work_of(from, first) + work_of(halfway, second);
                take(second, change.cwiseAbs(), work, (work - work_of(from, at_once)).cwiseAbs(), 2);
                return after(halfway, second, half);
            }
            expected = second.forces();
        } else if (level >= most_halvings_to_answer) {
            return std::nullopt;
        }
        const std::optional<State> there = advance(from, begin, middle, first, level + 1);
        if (!there) return std::nullopt;
        return advance(*there, middle, end, solve(*there, middle, end, expected), level + 1);
    }

    /// An increment whose halves have no answer: all that it changes counts as its error.
    std::optional<State> take_unchecked(const State& from, const Increment& at_once, double size) {
        if (!at_once.has_answer()) return std::nullopt;
        const VectorXd work = work_of(from, at_once);
        path_->way.is_broken = true;
        take(at_once, (at_once.forces() - from.forces).cwiseAbs(), work, work.cwiseAbs(), 1);
        return after(from, at_once, size);
    }

    const ContactQp& qp_;
    const PathStart& start_;
    const VectorXd& weight_;
    const MotionSplit& split_;
    const MatrixXd& levers_;
    double tolerance_;
    bool is_at_once_;
    std::vector<Face> faces_;
    std::shared_ptr<KeptStates> kept_ = std::make_shared<KeptStates>();
    double scale_ = 0, from_ = 0;  ///< of the path: where something presses first
    VectorXd approach_{};          ///< of the rows, at once
    VectorXd given_way_{};         ///< amplitudes by which bodies give way to the end
    int iterations_ = 0;
    std::optional<FrictionPath> path_{};
};

}  // namespace

PathStart path_start(const AssemblyProblem& problem, const AssemblyRows& all, const MatrixXd& modes) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    PathStart start{all.rows.gap0, VectorXd::Zero(offset.back()), !problem.before.empty()};
    const Index first_constraint = all.rows.n - static_cast<Index>(problem.constraints.size());
    const Index n_constraints = all.rows.n - first_constraint;
    start.gap.tail(n_constraints).setZero();
    if (!start.is_loaded) {
        for (Index row = 0; row < first_constraint; ++row)
            if (all.rows.unilateral[static_cast<std::size_t>(row)]) start.gap[row] = std::max(0.0, start.gap[row]);
    } else {
        ENSURE(problem.before.size() == problem.parts.size(), "every part has a state before, or none has");
        for (std::size_t i = 0; i < problem.parts.size(); ++i) {
            const StateBefore& before = problem.before[i];
            start.gap += opening_of(all.rows, i, before.under_load);
            if (n_constraints > 0)  // held as they were, whatever they are held at now
                start.gap.tail(n_constraints) -= opening_of(all.rows, i, before.displacement).tail(n_constraints);
            start.mode_load.segment(offset[i], offset[i + 1] - offset[i]) = problem.parts[i].modes.transpose() * before.load;
        }
    }
    start.gap = start.gap.cwiseQuotient(all.rows.weight);
    if (start.is_loaded) {
        std::vector<VectorXd> under_load;
        for (const StateBefore& before : problem.before) under_load.push_back(before.under_load);
        start.gap += modes * least_amplitudes(problem.parts, under_load);
    }
    return start;
}

VectorXd unheld_amplitudes(const std::vector<PartSystem>& parts, int threads) {
    std::vector<VectorXd> displacement(parts.size());
    parallel_for(static_cast<int>(parts.size()), threads, [&](int k) {
        const PartSystem& part = parts[at(k)];
        if (part.modes.cols() > 0 && !(part.load.isZero(0) && part.prescribed.isZero(0)))
            displacement[at(k)] = solve(part, part.load);
    });
    return least_amplitudes(parts, displacement);
}

FrictionPath follow_path(ContactQp qp, const PathStart& start, const VectorXd& unheld, const VectorXd& weight,
                         const MotionSplit& split, const MatrixXd& levers, std::optional<double> tolerance) {
    move_bodies(unheld, qp);
    FrictionPath path = Path(qp, start, weight, split, levers, tolerance).follow();
    path.moved = path.moved.size() > 0 ? VectorXd(unheld + path.moved) : unheld;
    return path;
}

}  // namespace abut::solver
