// SPDX-License-Identifier: GPL-3.0-or-later
// The factor of a set of states of the contact problem with friction, kept from one set to the next.
#pragma once
#include <optional>
#include <vector>

#include "solver/contact/friction_system.hpp"

namespace abut::solver {

/// Searches come from set to set by a few rows, and from load to load by none: what is factored once answers them all.
class KeptStates {
public:
    /// The point of solve_states without a proximal term, to rounding. False, and the point is not touched: the set is close to
    /// singular.
    bool solve(const ShiftedQp& shifted, const ActiveSet& states, ContactState& state);

private:
    struct Base {
        FactoredStates factored;
        std::vector<std::optional<StatesPoint>> responses;  ///< by row: to a unit residual
        std::size_t n_responses = 0;
    };
    bool factor(const ContactQp& qp, const ActiveSet& states);
    /// The rows whose states are not those that are factored, with their responses known; nothing: the set is close to
    /// singular. Many rows are none: their set is factored.
    std::optional<std::vector<Eigen::Index>> changes_to(const ContactQp& qp, const ActiveSet& states);

    std::optional<Base> base_{};
};

}  // namespace abut::solver
