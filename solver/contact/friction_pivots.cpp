// SPDX-License-Identifier: GPL-3.0-or-later
// The path: A x = b + t c, t from 0 to 1, with a row of A for each row of the contact problem (its gap is closed, or its
// multiplier is nothing, or what its pressure makes it) and one for each amplitude. One set of states is factored; along the
// path rows that have changed since are residuals of it, one for each, which a small system holds to their new equations. It
// has one more unknown than equations, the way t: its kernel is the direction of the path, whether A is singular or not.
#include "solver/contact/friction_pivots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "solver/contact/friction_states.hpp"
#include "solver/contact/friction_system.hpp"
#include "solver/linear_algebra/dense.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t longest_singular = 2;  // as many changes as are usual, where states on the path are singular
constexpr int pivots_a_row = 4;              // before a path is given up
constexpr double slack = 1e-6;     // of the largest opening: what rows have to spare where the path begins, if they lack some
constexpr double no_rate = 1e-13;  // of the largest: rounding
constexpr double way_end = 1 + 1e-9;  // of the way to a bend: what bends where the path ends does so behind it

/// What must stay positive as long as a row keeps its state. Bounds: the traction may grow to them forward or backward.
enum class Keeps { pressure, gap, forward_bound, backward_bound, slip };
struct Limit {
    Index row = -1;
    Keeps keeps = Keeps::gap;
    bool operator==(const Limit& other) const { return row == other.row && keeps == other.keeps; }
};

class StatePath {
public:
    StatePath(const ShiftedQp& shifted, const Proximal& proximal)
        : qp_(shifted.qp),
          proximal_(proximal),
          unit_(force_unit(shifted.qp)),
          gap_(shifted.gap),
          load_(shifted.qp.mode_load),
          friction_(friction_by_row(shifted.qp)) {}
    StatePath(const StatePath&) = delete;
    StatePath& operator=(const StatePath&) = delete;

    /// The states at its end.
    std::optional<ActiveSet> follow(const ActiveSet& states, const ContactState& start, int& pivots) {
        begin(states, start);
        if (!factor()) return std::nullopt;
        StatesPoint direction = along_;
        double rate = 1;
        Limit entered;
        const int most_pivots = pivots_a_row * static_cast<int>(gap_.size());
        for (int pivot = 0; pivot < most_pivots; ++pivot) {
            const auto [bend, way] = next_bend(direction, rate, entered);
            if (rate > 0 && 1 - way_ <= rate * way * way_end) return states_;
            if (bend.row < 0) return std::nullopt;
            point_.add(way, direction);
            way_ += rate * way;
            if (way_ < 0) return std::nullopt;
            ++pivots;
            entered = cross(bend);
            if (const std::size_t most = factored_->most_changes(); changed_.size() >= most)
                if (!factor() && changed_.size() >= longest_singular * most) return std::nullopt;
            if (!turn(entered, direction, rate)) return std::nullopt;
        }
        return std::nullopt;
    }

private:
    bool is_tangential(Index row) const { return friction_[index_of(row)] && friction_[index_of(row)]->tangential == row; }

    /// The point on the first states, moved into the cones, and the gaps and loads that it is the solution under.
    void begin(const ActiveSet& states, const ContactState& start) {
        states_ = states;
        point_.forces = start.multipliers / unit_;
        point_.amplitudes = start.amplitudes;
        for (std::size_t k = 0; k < states.size(); ++k)
            if (double& force = point_.forces[static_cast<Index>(k)];
                qp_.unilateral[k] && (states[k] == row_state::open || !(force > 0))) {
                states_[k] = row_state::open;
                force = 0;
            }
        for (const FrictionRow& f : qp_.friction) {
            double& traction = point_.forces[f.tangential];
            char& state = states_[index_of(f.tangential)];
            const double bound = f.coefficient * point_.forces[f.normal];
            if (states_[index_of(f.normal)] == row_state::open)
                state = row_state::open;
            else if (state == row_state::closed && std::abs(traction) > bound)
                state = traction < 0 ? row_state::slips_forward : row_state::slips_backward;
            if (state != row_state::closed) traction = -direction_of(state) * bound;
        }
        point_.opening = unit_ * (qp_.compliance * point_.forces) + qp_.modes * point_.amplitudes;
        begin_gap_ = point_.opening + gap_;
        const VectorXd closing = unit_ * (qp_.compliance * point_.forces);
        const double least = slack * std::max(closing.cwiseAbs().maxCoeff(), -begin_gap_.minCoeff());
        for (std::size_t k = 0; k < states_.size(); ++k) {
            const auto row = static_cast<Index>(k);
            double& gap = begin_gap_[row];
            if (states_[k] == row_state::closed)
                gap = 0;
            else if (const double way = is_tangential(row) ? direction_of(states_[k]) : 1; way != 0)
                gap = way * std::max(way * gap, least * spread(row));
        }
        begin_gap_ -= point_.opening;
        begin_load_ =
            proximal_.stiffness * (point_.amplitudes - proximal_.anchor) - unit_ * (qp_.modes.transpose() * point_.forces);
        way_ = 0;
    }

    /// Fractions between 1/2 and 1 that no two rows share: what bends at once has no order.
    static double spread(Index row) {
        constexpr double golden = 0.6180339887498949;
        const double x = golden * static_cast<double>(row + 1);
        return 0.5 + 0.5 * (x - std::floor(x));
    }

    /// Factors the states where the path is. False: they are singular, and nothing is changed.
    bool factor() {
        FactoredStates factored(qp_, proximal_.stiffness, states_);
        if (!factored.succeeded()) return false;
        factored_.emplace(std::move(factored));
        along_ = answer_to(begin_gap_ - gap_, (begin_load_ - load_) / unit_);
        if (way_ > 0) {
            const VectorXd gap = begin_gap_ + way_ * (gap_ - begin_gap_), load = begin_load_ + way_ * (load_ - begin_load_);
            point_ = answer_to(-gap, -(load + proximal_.stiffness * proximal_.anchor) / unit_);
        }
        changed_.clear();
        responses_.clear();
        return true;
    }
    /// The point with these gaps of the closed rows.
    StatesPoint answer_to(VectorXd gap, const VectorXd& load) const {
        for (std::size_t k = 0; k < states_.size(); ++k)
            if (states_[k] != row_state::closed) gap[static_cast<Index>(k)] = 0;
        StatesPoint point = factored_->answer(gap, load);
        factored_->fill_opening(point);
        return point;
    }

    double value(const Limit& limit, const VectorXd& forces, const VectorXd& gap) const {
        const FrictionRow* f = friction_[index_of(limit.row)];
        switch (limit.keeps) {
            case Keeps::pressure:
                return forces[limit.row];
            case Keeps::gap:
                return gap[limit.row];
            case Keeps::forward_bound:
                return f->coefficient * forces[f->normal] - forces[f->tangential];
            case Keeps::backward_bound:
                return f->coefficient * forces[f->normal] + forces[f->tangential];
            case Keeps::slip:
                return direction_of(states_[index_of(limit.row)]) * gap[limit.row];
        }
        return 0;
    }

    template <class Use>
    void for_each_limit(const Use& use) const {
        for (std::size_t k = 0; k < states_.size(); ++k) {
            const auto row = static_cast<Index>(k);
            if (is_tangential(row)) {
                if (states_[k] == row_state::closed) {
                    use(Limit{row, Keeps::forward_bound});
                    use(Limit{row, Keeps::backward_bound});
                } else if (states_[k] != row_state::open) {
                    use(Limit{row, Keeps::slip});
                }
            } else if (qp_.unilateral[k]) {
                // what sticks is at its bound before it opens
                const bool sticks = friction_[k] && states_[index_of(friction_[k]->tangential)] == row_state::closed;
                if (states_[k] == row_state::open)
                    use(Limit{row, Keeps::gap});
                else if (!sticks)
                    use(Limit{row, Keeps::pressure});
            }
        }
    }

    /// The limit that a direction reaches first, and after which way; none: no row. What has just entered moves away from its
    /// own.
    std::pair<Limit, double> next_bend(const StatesPoint& direction, double rate, const Limit& entered) const {
        const VectorXd gap = gap_here(), opens = direction.opening + rate * (gap_ - begin_gap_);
        const double least_force = no_rate * direction.forces.cwiseAbs().maxCoeff();
        const double least_gap = no_rate * opens.cwiseAbs().maxCoeff();
        Limit first;
        double way = std::numeric_limits<double>::infinity();
        for_each_limit([&](const Limit& limit) {
            const bool is_gap = limit.keeps == Keeps::gap || limit.keeps == Keeps::slip;
            const double falls = -value(limit, direction.forces, opens);
            if (!(falls > (is_gap ? least_gap : least_force)) || limit == entered) return;
            const double there = std::max(0.0, value(limit, point_.forces, gap)) / falls;
            if (!(there < way)) return;
            way = there;
            first = limit;
        });
        return {first, way};
    }
    VectorXd gap_here() const { return point_.opening + begin_gap_ + way_ * (gap_ - begin_gap_); }

    /// The row of a limit changes its state; what moves away from its own limit then.
    Limit cross(const Limit& limit) {
        const FrictionRow* f = friction_[index_of(limit.row)];
        char& state = states_[index_of(limit.row)];
        change(limit.row);
        switch (limit.keeps) {
            case Keeps::pressure:
            case Keeps::gap: {
                const bool opens = limit.keeps == Keeps::pressure;
                state = opens ? row_state::open : row_state::closed;
                if (f) {
                    change(f->tangential);
                    states_[index_of(f->tangential)] = opens                            ? row_state::open
                                                       : gap_here()[f->tangential] >= 0 ? row_state::slips_forward
                                                                                        : row_state::slips_backward;
                }
                return {limit.row, opens ? Keeps::gap : Keeps::pressure};
            }
            case Keeps::forward_bound:
                state = row_state::slips_backward;
                return {limit.row, Keeps::slip};
            case Keeps::backward_bound:
                state = row_state::slips_forward;
                return {limit.row, Keeps::slip};
            case Keeps::slip: {
                const Keeps bound = direction_of(state) > 0 ? Keeps::backward_bound : Keeps::forward_bound;
                state = row_state::closed;
                return {limit.row, bound};
            }
        }
        return {};
    }

    /// A row is to have another equation than what is factored.
    void change(Index row) {
        if (std::find(changed_.begin(), changed_.end(), row) != changed_.end()) return;
        changed_.push_back(row);
        responses_.push_back(factored_->answer(VectorXd::Unit(gap_.size(), row), VectorXd::Zero(load_.size())));
        factored_->fill_opening(responses_.back());
    }

    /// The direction after a bend. False: it is not determined.
    bool turn(const Limit& entered, StatesPoint& direction, double& rate) const {
        const Index m = static_cast<Index>(changed_.size());
        MatrixXd left(m, m + 1);
        for (Index i = 0; i < m; ++i) {
            const Index row = changed_[index_of(i)];
            for (Index j = 0; j < m; ++j) left(i, j) = left_of(row, states_, friction_, responses_[index_of(j)]);
            left(i, m) = left_of(row, states_, friction_, along_) +
                         (states_[index_of(row)] == row_state::closed ? gap_[row] - begin_gap_[row] : 0);
        }
        const std::optional<VectorXd> kernel = kernel_of(left);
        if (!kernel) return false;
        rate = (*kernel)[m];
        const Index rows = gap_.size(), n = load_.size();
        direction = {VectorXd::Zero(rows), VectorXd::Zero(n), VectorXd::Zero(rows)};
        direction.add(rate, along_);
        for (Index j = 0; j < m; ++j) direction.add((*kernel)[j], responses_[index_of(j)]);
        const double opens = value(entered, direction.forces, direction.opening + rate * (gap_ - begin_gap_));
        if (!(std::abs(opens) > 0)) return false;
        if (opens < 0) {
            rate = -rate;
            direction = {-direction.forces, -direction.amplitudes, -direction.opening};
        }
        return true;
    }

    const ContactQp& qp_;
    const Proximal& proximal_;
    double unit_;
    const VectorXd &gap_, &load_;  ///< at the end of the path
    FrictionByRow friction_;
    VectorXd begin_gap_{}, begin_load_{};  ///< where it begins
    ActiveSet states_{};
    StatesPoint point_{};
    double way_ = 0;
    std::optional<FactoredStates> factored_{};
    StatesPoint along_{};                   ///< the direction of the factored states
    std::vector<Index> changed_{};          ///< rows, since these
    std::vector<StatesPoint> responses_{};  ///< of the factored states to a unit residual of each
};

}  // namespace

bool pivot_states(const ShiftedQp& shifted, const Proximal& proximal, ActiveSet& states, ContactState& state, int& iterations) {
    if (shifted.gap.size() == 0) return false;
    const std::optional<ActiveSet> found = StatePath(shifted, proximal).follow(states, state, iterations);
    ContactState there;
    if (!found || !solve_states(shifted, proximal, *found, there)) return false;
    states = *found;
    state = std::move(there);
    return true;
}

}  // namespace abut::solver
