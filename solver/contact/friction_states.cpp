// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/friction_states.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/linear_algebra/box_qp.hpp"
#include "solver/linear_algebra/complementarity.hpp"
#include "solver/linear_algebra/dense.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_newton_steps = 60;  // 33 are the most that 5300 rows were seen to take
constexpr int most_steps_astray = 10;  // nearer to no solution: beyond, one in two hundred finds back
constexpr double least_step = 1.0 / 64;
constexpr double consistent = 1e-10;  // of the terms: what a singular system leaves is rounding
constexpr double at_bound = 1e-12;    // of the largest multiplier: a traction so near to its bound is there
constexpr double dependent = 1e-8;    // of the longest row of motions: less is rounding of what others hold
constexpr int most_rounds = 6;        // of given bounds: where friction is moderate, three are enough

std::size_t of(Index row) {
    return static_cast<std::size_t>(row);
}

double direction_of(char state) {
    if (state == row_state::slips_forward) return 1;
    return state == row_state::slips_backward ? -1 : 0;
}

/// Multipliers by the unknown ones: those of closed rows, and tractions that follow from pressures.
struct Unknowns {
    std::vector<Index> rows;    // closed
    std::vector<Index> column;  // by row: its place among them, or -1
    struct Slip {
        Index tangential, column;
        double factor;  // of the pressure
    };
    std::vector<Slip> slips{};
};

Unknowns unknowns_of(const ContactQp& qp, const ActiveSet& states) {
    Unknowns u{{}, std::vector<Index>(states.size(), -1)};
    for (std::size_t k = 0; k < states.size(); ++k) {
        if (states[k] != row_state::closed) continue;
        u.column[k] = static_cast<Index>(u.rows.size());
        u.rows.push_back(static_cast<Index>(k));
    }
    for (const FrictionRow& f : qp.friction)
        if (const double way = direction_of(states[of(f.tangential)]); way != 0 && u.column[of(f.normal)] >= 0)
            u.slips.push_back({f.tangential, u.column[of(f.normal)], -way * f.coefficient});
    return u;
}

/// Forces by unit of length: what makes compliances and modes comparable.
double force_unit(const ContactQp& qp) {
    const double softest = qp.compliance.diagonal().maxCoeff();
    return softest > 0 ? 1 / softest : 1;
}

/// Unknowns: closed multipliers over the force unit, amplitudes of `modes` under a `stiffness`.
MatrixXd matrix_of(const ContactQp& qp, const MatrixXd& modes, const MatrixXd& stiffness, const Unknowns& u, double unit) {
    const Index m = static_cast<Index>(u.rows.size()), n = modes.cols();
    MatrixXd a(m + n, m + n);
    for (Index j = 0; j < m; ++j)
        for (Index i = 0; i < m; ++i) a(i, j) = unit * qp.compliance(u.rows[of(i)], u.rows[of(j)]);
    for (const Unknowns::Slip& s : u.slips)
        for (Index i = 0; i < m; ++i) a(i, s.column) += s.factor * unit * qp.compliance(u.rows[of(i)], s.tangential);
    if (n == 0) return a;
    for (Index j = 0; j < m; ++j) {
        a.row(j).tail(n) = modes.row(u.rows[of(j)]);
        a.col(j).tail(n) = a.row(j).tail(n).transpose();
    }
    for (const Unknowns::Slip& s : u.slips) a.col(s.column).tail(n) += s.factor * modes.row(s.tangential).transpose();
    a.bottomRightCorner(n, n) = -stiffness / unit;
    return a;
}

std::optional<VectorXd> solved(const MatrixXd& a, const VectorXd& b) {
    if (std::optional<VectorXd> x = solve_square(a, b); x && x->allFinite()) return x;
    VectorXd x = least_squares(a, b);
    const double terms = (a.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs()).maxCoeff();
    const bool is_consistent = (a * x - b).cwiseAbs().maxCoeff() <= consistent * terms;  // false of what is no number, too
    return is_consistent ? std::optional(x) : std::nullopt;
}

/// What multipliers over the force unit do to gaps where the amplitudes follow: C + G E^-1 G', and the gaps without any.
struct Gaps {
    MatrixXd follow;  ///< E^-1 G' (n x m)
    VectorXd gap;
};

Gaps gaps_of(const ShiftedQp& shifted, const Proximal& proximal) {
    const ContactQp& qp = shifted.qp;
    if (qp.modes.cols() == 0) return {MatrixXd(0, qp.gap.size()), shifted.gap};
    const Cholesky stiffness(proximal.stiffness);
    return {stiffness.solve_columns(qp.modes.transpose()),
            shifted.gap + qp.modes * (proximal.anchor + stiffness.solve(qp.mode_load))};
}

/// The complementarity problem in z = (pressures, l_t + mu l_n, slip backward), bilateral rows and amplitudes eliminated.
class Pivots {
public:
    Pivots(const ShiftedQp& shifted, const Proximal& proximal) : qp_(shifted.qp) {
        Gaps gaps = gaps_of(shifted, proximal);
        c_ = force_unit(qp_) * (qp_.compliance.to_dense() + qp_.modes * gaps.follow);
        g_ = std::move(gaps.gap);
        sort_rows();
        eliminate_bilateral();
    }

    /// expected: states to begin from.
    std::optional<ActiveSet> states(const ActiveSet& expected, const VectorXd& gap, Ties by) const {
        const Index u = static_cast<Index>(pressed_.size()), f = static_cast<Index>(qp_.friction.size()), n = u + 2 * f;
        VectorXd mu(f);
        for (Index k = 0; k < f; ++k) mu[k] = qp_.friction[of(k)].coefficient;
        // the friction rows' pressures come first among the pressed ones
        MatrixXd m = MatrixXd::Zero(n, n);
        m.topLeftCorner(u + f, u + f) = c_;
        m.topLeftCorner(u + f, f) -= c_.rightCols(f) * mu.asDiagonal();
        for (Index k = 0; k < f; ++k) {
            m(u + k, u + f + k) = 1;
            m(u + f + k, k) = 2 * mu[k];
            m(u + f + k, u + k) = -1;
        }
        VectorXd q = VectorXd::Zero(n);
        q.head(u + f) = g_;
        VectorXd ties = VectorXd::Ones(n);
        if (by == Ties::of_bounds) ties.tail(f) = mu.cwiseMin(1);
        const std::optional<VectorXd> z = complementary(m, q, positive_in(expected, gap), ties);
        if (!z) return std::nullopt;
        const VectorXd w = m * *z + q;
        ActiveSet states = bilateral_rows(qp_);
        for (Index k = 0; k < u; ++k) states[of(pressed_[of(k)])] = (*z)[k] > 0;
        for (Index k = 0; k < f; ++k) {
            char& state = states[of(qp_.friction[of(k)].tangential)];
            state = !((*z)[k] > 0)        ? row_state::open
                    : (*z)[u + f + k] > 0 ? row_state::slips_backward
                    : (*z)[u + k] > 0     ? row_state::closed
                                          : row_state::slips_forward;
        }
        return states;
    }

private:
    /// Which z are positive; nothing where the gaps of the states are not known. Open rows have slip, too.
    std::vector<char> positive_in(const ActiveSet& states, const VectorXd& gap) const {
        if (gap.size() == 0) return {};
        const std::size_t u = pressed_.size(), f = qp_.friction.size();
        std::vector<char> positive(u + 2 * f);
        for (std::size_t k = 0; k < u; ++k) positive[k] = states[of(pressed_[k])] != row_state::open;
        for (std::size_t k = 0; k < f; ++k) {
            const Index row = qp_.friction[k].tangential;
            const char state = states[of(row)];
            const bool backward = state == row_state::slips_backward || (state == row_state::open && gap[row] < 0);
            positive[u + k] = state == row_state::closed || backward;
            positive[u + f + k] = backward;
        }
        return positive;
    }

    void sort_rows() {
        std::vector<char> is_friction(qp_.unilateral.size(), 0);
        for (const FrictionRow& f : qp_.friction) {
            pressed_.push_back(f.normal);
            is_friction[of(f.normal)] = is_friction[of(f.tangential)] = 1;
        }
        for (std::size_t k = 0; k < qp_.unilateral.size(); ++k)
            if (!is_friction[k]) (qp_.unilateral[k] ? pressed_ : bilateral_).push_back(static_cast<Index>(k));
    }

    void eliminate_bilateral() {
        std::vector<Index> kept = pressed_;
        for (const FrictionRow& f : qp_.friction) kept.push_back(f.tangential);
        MatrixXd c = c_(kept, kept);
        VectorXd g = g_(kept);
        if (!bilateral_.empty()) {
            const PivotedCholesky held(c_(bilateral_, bilateral_));
            const MatrixXd both = c_(kept, bilateral_);
            c -= both * held.solve_columns(both.transpose());
            g -= both * held.solve(g_(bilateral_));
        }
        c_ = std::move(c);
        g_ = std::move(g);
    }

    const ContactQp& qp_;
    MatrixXd c_;
    VectorXd g_;
    std::vector<Index> pressed_, bilateral_;
};

}  // namespace

ActiveSet states_of(const ContactQp& qp, const VectorXd& multipliers) {
    ActiveSet states = bilateral_rows(qp);
    for (std::size_t k = 0; k < states.size(); ++k)
        if (multipliers[static_cast<Index>(k)] > 0) states[k] = row_state::closed;
    const double rounding = at_bound * (multipliers.size() > 0 ? multipliers.cwiseAbs().maxCoeff() : 0.0);
    for (const FrictionRow& f : qp.friction) {
        char& state = states[of(f.tangential)];
        const double traction = multipliers[f.tangential], bound = f.coefficient * multipliers[f.normal];
        state = states[of(f.normal)];
        if (state == row_state::closed && std::abs(traction) >= bound - rounding)
            state = traction < 0 ? row_state::slips_forward : row_state::slips_backward;
    }
    return states;
}

HeldMotions::HeldMotions(const ContactQp& qp)
    : modes_(qp.modes),
      basis_(MatrixXd::Zero(qp.modes.cols(), qp.modes.cols())),
      rounding_(qp.modes.size() > 0 ? dependent * qp.modes.rowwise().norm().maxCoeff() : 0) {}

bool HeldMotions::hold(Index row) {
    if (are_all()) return false;
    const VectorXd motion = free_part(modes_.row(row).transpose());
    if (!(motion.norm() > rounding_)) return false;
    basis_.col(n_++) = motion.normalized();
    return true;
}

VectorXd HeldMotions::free_part(const VectorXd& motion) const {
    const auto held = basis_.leftCols(n_);
    const VectorXd once = motion - held * (held.transpose() * motion);
    return once - held * (held.transpose() * once);  // what rounding left
}

HeldMotions held_motions(const ContactQp& qp, const ActiveSet& states) {
    HeldMotions held(qp);
    for (std::size_t k = 0; k < states.size() && !held.are_all(); ++k)
        if (states[k] == row_state::closed) held.hold(static_cast<Index>(k));
    return held;
}

bool acts_on_free(const ContactQp& qp, const HeldMotions& held, const VectorXd& forces) {
    if (held.are_all()) return false;
    const VectorXd of_rows = qp.modes.transpose() * forces;
    const double terms = (qp.mode_load.cwiseAbs() + qp.modes.cwiseAbs().transpose() * forces.cwiseAbs()).maxCoeff();
    return held.free_part(qp.mode_load + of_rows).cwiseAbs().maxCoeff() > consistent * terms;
}

bool solve_states(const ShiftedQp& shifted, const Proximal& proximal, const ActiveSet& states, ContactState& state) {
    const ContactQp& qp = shifted.qp;
    const Unknowns u = unknowns_of(qp, states);
    const double unit = force_unit(qp);
    const bool is_exact = proximal.stiffness.isZero(0);
    const std::optional<HeldMotions> held = is_exact ? std::optional(held_motions(qp, states)) : std::nullopt;
    const MatrixXd modes = held ? MatrixXd(qp.modes * held->basis()) : qp.modes;
    const Index m = static_cast<Index>(u.rows.size()), n = modes.cols();
    const VectorXd load = qp.mode_load + proximal.stiffness * proximal.anchor;
    VectorXd right(m + n);
    right.head(m) = -shifted.gap(u.rows);
    right.tail(n) = -(held ? VectorXd(held->basis().transpose() * load) : load) / unit;
    const MatrixXd stiffness = is_exact ? MatrixXd::Zero(n, n) : proximal.stiffness;
    const std::optional<VectorXd> x = solved(matrix_of(qp, modes, stiffness, u, unit), right);
    if (!x) return false;
    state.multipliers = VectorXd::Zero(shifted.gap.size());
    state.multipliers(u.rows) = unit * x->head(m);
    for (const Unknowns::Slip& s : u.slips) state.multipliers[s.tangential] = s.factor * unit * (*x)[s.column];
    state.amplitudes = held ? VectorXd(held->basis() * x->tail(n)) : VectorXd(x->tail(n));
    if (held && acts_on_free(qp, *held, state.multipliers)) return false;
    state.closing = qp.compliance * state.multipliers;
    return true;
}

ActiveSet next_states(const ShiftedQp& shifted, const ActiveSet& states, const ContactState& s) {
    ActiveSet next = next_set(shifted, states, s);
    const VectorXd gap = gap_of(shifted, s), rounding = gap_rounding(shifted, s);
    const double trifle = at_bound * s.multipliers.cwiseAbs().maxCoeff();
    for (const FrictionRow& f : shifted.qp.friction) {
        const char before = states[of(f.tangential)];
        char& state = next[of(f.tangential)];
        const double traction = s.multipliers[f.tangential], bound = f.coefficient * s.multipliers[f.normal];
        state = next[of(f.normal)];
        if (state == row_state::open) continue;
        if (before == row_state::closed && std::abs(traction) > bound + trifle)
            state = traction < 0 ? row_state::slips_forward : row_state::slips_backward;
        else if (const double way = direction_of(before); way != 0 && way * gap[f.tangential] >= -rounding[f.tangential])
            state = before;
    }
    return next;
}

namespace {

/// What the multipliers of a point lack of what its gaps ask for: of each row its own compliance tells which force closes a
/// gap. Natural residuals; zero at a solution alone.
class Lack {
public:
    explicit Lack(const ShiftedQp& shifted) : qp_(shifted.qp), compliance_(shifted.qp.compliance.diagonal()) {
        const double least = std::numeric_limits<double>::epsilon() * compliance_.maxCoeff();
        compliance_ = compliance_.cwiseMax(least);
    }

    /// The states that a point asks for; of one that a step ends at those of next_states, which knows its rounding.
    ActiveSet states(const VectorXd& multipliers, const VectorXd& gap) const {
        const VectorXd wanted = multipliers - gap.cwiseQuotient(compliance_);
        ActiveSet states = bilateral_rows(qp_);
        for (std::size_t k = 0; k < states.size(); ++k)
            if (qp_.unilateral[k] && wanted[static_cast<Index>(k)] > 0) states[k] = row_state::closed;
        for (const FrictionRow& f : qp_.friction) {
            const double traction = wanted[f.tangential], bound = f.coefficient * wanted[f.normal];
            char& state = states[of(f.tangential)] = states[of(f.normal)];
            if (state == row_state::closed && std::abs(traction) > bound)
                state = traction < 0 ? row_state::slips_forward : row_state::slips_backward;
        }
        return states;
    }

    /// Bodies that slip everywhere are free to roll or slide. Where they would be, what is least beyond its bound sticks: round
    /// bodies between others are held by a single row at its bound. True: something has been held.
    bool hold_free_motions(const VectorXd& multipliers, const VectorXd& gap, ActiveSet& states) const {
        HeldMotions held = held_motions(qp_, states);
        if (held.are_all()) return false;
        const VectorXd wanted = multipliers - gap.cwiseQuotient(compliance_);
        std::vector<std::pair<double, Index>> slipping;
        for (const FrictionRow& f : qp_.friction)
            if (direction_of(states[of(f.tangential)]) != 0)
                slipping.emplace_back(std::abs(wanted[f.tangential]) / (f.coefficient * wanted[f.normal]), f.tangential);
        std::sort(slipping.begin(), slipping.end());
        bool any = false;
        for (const auto& [beyond, row] : slipping) {
            if (held.are_all()) break;
            if (!held.hold(row)) continue;
            states[of(row)] = row_state::closed;
            any = true;
        }
        return any;
    }

    /// The sum of the residuals' squares, as energies.
    double energy(const VectorXd& multipliers, const VectorXd& gap) const {
        const VectorXd wanted = multipliers - gap.cwiseQuotient(compliance_);
        VectorXd lack = multipliers - wanted;
        for (std::size_t k = 0; k < qp_.unilateral.size(); ++k) {
            const auto row = static_cast<Index>(k);
            if (qp_.unilateral[k]) lack[row] = multipliers[row] - std::max(0.0, wanted[row]);
        }
        for (const FrictionRow& f : qp_.friction) {
            const double bound = f.coefficient * std::max(0.0, wanted[f.normal]);
            lack[f.tangential] = multipliers[f.tangential] - std::clamp(wanted[f.tangential], -bound, bound);
        }
        return lack.cwiseAbs2().dot(compliance_);
    }

private:
    const ContactQp& qp_;
    VectorXd compliance_;
};

/// Friction whose bounds are those of pressures before, whatever presses now (Tresca's): a convex problem.
class GivenBounds {
public:
    GivenBounds(const ShiftedQp& shifted, const Proximal& proximal)
        : qp_(shifted.qp), unit_(force_unit(qp_)), gaps_(gaps_of(shifted, proximal)) {
        compliance_.times = [this](const VectorXd& l) -> VectorXd {
            return unit_ * (qp_.compliance * l + qp_.modes * (gaps_.follow * l));
        };
        compliance_.among = [this](const std::vector<Index>& rows) -> MatrixXd {
            MatrixXd c = qp_.modes(rows, Eigen::all) * gaps_.follow(Eigen::all, rows);
            for (std::size_t j = 0; j < rows.size(); ++j)
                for (std::size_t i = 0; i < rows.size(); ++i)
                    c(static_cast<Index>(i), static_cast<Index>(j)) += qp_.compliance(rows[i], rows[j]);
            return unit_ * c;
        };
        compliance_.diagonal = qp_.compliance.diagonal();
        if (qp_.modes.cols() > 0) compliance_.diagonal += qp_.modes.cwiseProduct(gaps_.follow.transpose()).rowwise().sum();
        compliance_.diagonal *= unit_;
    }
    GivenBounds(const GivenBounds&) = delete;
    GivenBounds& operator=(const GivenBounds&) = delete;

    /// forces: multipliers before, whose pressures give the bounds, and those found. The states of these; nothing: none are.
    std::optional<ActiveSet> states(VectorXd& forces, int& iterations) const {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        VectorXd upper = VectorXd::Constant(forces.size(), infinity), lower = -upper;
        for (std::size_t k = 0; k < qp_.unilateral.size(); ++k)
            if (qp_.unilateral[k]) lower[static_cast<Index>(k)] = 0;
        for (const FrictionRow& f : qp_.friction) {
            const double pressure = forces[f.normal] / unit_;
            upper[f.tangential] = f.coefficient * std::max(0.0, pressure);
            lower[f.tangential] = -upper[f.tangential];
        }
        const std::optional<VectorXd> l = minimize_in_box(compliance_, gaps_.gap, lower, upper, forces / unit_, iterations);
        if (!l) return std::nullopt;
        ActiveSet states = bilateral_rows(qp_);
        for (std::size_t k = 0; k < states.size(); ++k)
            if (qp_.unilateral[k] && (*l)[static_cast<Index>(k)] > 0) states[k] = row_state::closed;
        for (const FrictionRow& f : qp_.friction) {
            char& state = states[of(f.tangential)] = states[of(f.normal)];
            if (state == row_state::open || !(upper[f.tangential] > 0)) continue;
            if ((*l)[f.tangential] <= lower[f.tangential]) state = row_state::slips_forward;
            if ((*l)[f.tangential] >= upper[f.tangential]) state = row_state::slips_backward;
        }
        forces = unit_ * *l;
        return states;
    }

private:
    const ContactQp& qp_;
    double unit_;
    Gaps gaps_;
    Semidefinite compliance_;
};

}  // namespace

SetSearch search_states(const ShiftedQp& shifted, const Proximal& proximal, ActiveSet& states, ContactState& state,
                        int& iterations) {
    const Lack lack(shifted);
    const bool is_exact = shifted.qp.modes.cols() > 0 && proximal.stiffness.isZero(0);
    VectorXd multipliers, gap;  // of the point that a step begins from
    double energy = std::numeric_limits<double>::infinity(), least = energy;
    int steps_since_least = 0;
    for (int step = 0; step < most_newton_steps; ++step) {
        ++iterations;
        if (!solve_states(shifted, proximal, states, state)) return SetSearch::singular;
        if (next_states(shifted, states, state) == states) return SetSearch::found;
        const VectorXd gap_there = gap_of(shifted, state);
        const double whole = lack.energy(state.multipliers, gap_there);
        steps_since_least = whole < least ? 0 : steps_since_least + 1;
        if (steps_since_least > most_steps_astray) return SetSearch::repeated;
        least = std::min(least, whole);
        if (step == 0 || whole < energy) {
            multipliers = state.multipliers;
            gap = gap_there;
            energy = whole;
        } else {
            const VectorXd way = state.multipliers - multipliers, opens = gap_there - gap;
            double share = 1;
            energy = whole;
            for (double part = 0.5; part >= least_step; part *= 0.5)
                if (const double e = lack.energy(multipliers + part * way, gap + part * opens); e < energy) {
                    share = part;
                    energy = e;
                }
            multipliers += share * way;
            gap += share * opens;
        }
        const ActiveSet before = std::exchange(states, lack.states(multipliers, gap));
        if (is_exact && lack.hold_free_motions(multipliers, gap, states) && states == before) return SetSearch::singular;
    }
    return SetSearch::repeated;
}

SetSearch search_by_bounds(const ShiftedQp& shifted, const Proximal& proximal, ActiveSet& states, ContactState& state,
                           int& iterations) {
    const GivenBounds given(shifted, proximal);
    VectorXd forces = VectorXd::Zero(shifted.gap.size());
    if (ContactState before; solve_states(shifted, proximal, states, before)) forces = before.multipliers;
    for (int round = 0; round < most_rounds; ++round) {
        std::optional<ActiveSet> under_bounds = given.states(forces, iterations);
        if (!under_bounds) return SetSearch::singular;
        states = std::move(*under_bounds);
        if (search_states(shifted, proximal, states, state, iterations) == SetSearch::found) return SetSearch::found;
    }
    return SetSearch::repeated;
}

std::optional<ActiveSet> pivoted_states(const ShiftedQp& shifted, const Proximal& proximal, const ActiveSet& expected,
                                        Ties ties) {
    ContactState state;
    const bool is_known = solve_states(shifted, proximal, expected, state);
    return Pivots(shifted, proximal).states(expected, is_known ? gap_of(shifted, state) : VectorXd(0), ties);
}

}  // namespace abut::solver
