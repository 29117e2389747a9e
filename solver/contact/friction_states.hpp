// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of states of the contact problem with friction: the solution on one, and the next one.
#pragma once
#include "solver/contact/friction.hpp"

namespace abut::solver {

/// The states that multipliers are at: what is pressed is closed, and sticks where its traction is below its bound.
ActiveSet states_of(const ContactQp& qp, const Eigen::VectorXd& multipliers);

/// Motions that rows hold, row by row: an orthonormal basis of those of their modes that are not of rows before.
class HeldMotions {
public:
    explicit HeldMotions(const ContactQp& qp);
    /// Takes a row. False: it holds nothing that is not held yet.
    bool hold(Eigen::Index row);
    bool are_all() const { return n_ == basis_.cols(); }
    /// What of a motion nothing holds.
    Eigen::VectorXd free_part(const Eigen::VectorXd& motion) const;
    auto basis() const { return basis_.leftCols(n_); }  ///< orthonormal

private:
    const Eigen::MatrixXd& modes_;
    Eigen::MatrixXd basis_;
    double rounding_;
    Eigen::Index n_ = 0;
};
/// The motions that closed rows hold, those that stick among them.
HeldMotions held_motions(const ContactQp& qp, const ActiveSet& states);

/// The point where closed rows have no gap, open ones no multiplier, and slipping ones the traction that their pressure gives
/// them. Without a proximal term what no row holds stays where it is. False: the rows ask for gaps that cannot be, or leave a
/// motion without its balance.
bool solve_states(const ShiftedQp& shifted, const Proximal& proximal, const ActiveSet& states, ContactState& state);

/// The states after a step: rows of pressure as in next_set; what sticks beyond its bound slips, what would slip against its
/// traction sticks, what closes sticks at first.
ActiveSet next_states(const ShiftedQp& shifted, const ActiveSet& states, const ContactState& state);

/// Semismooth Newton steps from `states`. A step that does not bring the residual of all conditions down is cut to where it is
/// least: whole steps run about where much sticks and slips.
SetSearch search_states(const ShiftedQp& shifted, const Proximal& proximal, ActiveSet& states, ContactState& state,
                        int& iterations);

}  // namespace abut::solver
