// SPDX-License-Identifier: GPL-3.0-or-later
// The linear system of a set of states of the contact problem with friction.
#pragma once
#include <cstddef>
#include <vector>

#include "solver/contact/friction.hpp"

namespace abut::solver {

inline std::size_t index_of(Eigen::Index row) {
    return static_cast<std::size_t>(row);
}

/// 1 where a row slips forward, -1 backward, else 0. Its traction is -1 times that of its bound.
inline double direction_of(char state) {
    if (state == row_state::slips_forward) return 1;
    return state == row_state::slips_backward ? -1 : 0;
}

/// Multipliers by the unknown ones: those of closed rows, and tractions that follow from pressures.
struct Unknowns {
    std::vector<Eigen::Index> rows;    ///< closed
    std::vector<Eigen::Index> column;  ///< by row: its place among them, or -1
    struct Slip {
        Eigen::Index tangential, column;
        double factor;  ///< of the pressure
    };
    std::vector<Slip> slips{};
};
Unknowns unknowns_of(const ContactQp& qp, const ActiveSet& states);

/// Forces by unit of length: what makes compliances and modes comparable.
double force_unit(const ContactQp& qp);

/// The equations of closed rows and of amplitudes of `modes` under a `stiffness`, in closed multipliers over the force unit and
/// these amplitudes.
Eigen::MatrixXd matrix_of(const ContactQp& qp, const Eigen::MatrixXd& modes, const Eigen::MatrixXd& stiffness,
                          const Unknowns& unknowns, double unit);

}  // namespace abut::solver
