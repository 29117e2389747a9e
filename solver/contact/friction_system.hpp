// SPDX-License-Identifier: GPL-3.0-or-later
// The linear system of a set of states of the contact problem with friction.
#pragma once
#include <cstddef>
#include <vector>

#include "solver/contact/friction.hpp"
#include "solver/linear_algebra/dense.hpp"

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

/// The friction that each row is a part of; null: none.
using FrictionByRow = std::vector<const FrictionRow*>;
FrictionByRow friction_by_row(const ContactQp& qp);

/// A point, or a direction: multipliers over the force unit, amplitudes, and what both open the rows by.
struct StatesPoint {
    Eigen::VectorXd forces, amplitudes, opening;
    void add(double factor, const StatesPoint& p) {
        forces += factor * p.forces;
        amplitudes += factor * p.amplitudes;
        opening += factor * p.opening;
    }
};

/// What a direction leaves of a row's equation: its opening where it is closed, else its multiplier beside what its pressure
/// makes it.
double left_of(Eigen::Index row, const ActiveSet& states, const FrictionByRow& friction, const StatesPoint& direction);

/// A set of states, factored.
class FactoredStates {
public:
    FactoredStates(const ContactQp& qp, const Eigen::MatrixXd& stiffness, const ActiveSet& states);
    bool succeeded() const { return factor_.succeeded(); }
    const ActiveSet& states() const { return states_; }
    /// Does a problem differ from that of the states by gaps and loads alone?
    bool is_of(const ContactQp& qp) const;
    /// How many rows may have other states before a new factor costs less than what they ask of this one.
    std::size_t most_changes() const { return 8 + unknowns_.rows.size() / 8; }
    double reciprocal_condition() const { return factor_.reciprocal_condition(); }

    /// The point with these residuals of rows (the opening of closed ones, of others the multiplier over the unit beside what
    /// their pressure makes it) and of amplitudes. Its opening is not filled in.
    StatesPoint answer(const Eigen::VectorXd& rows, const Eigen::VectorXd& amplitudes) const;
    void fill_opening(StatesPoint& point) const;
    /// Fills it in in these rows alone; the others are not touched.
    void fill_opening(StatesPoint& point, const std::vector<Eigen::Index>& rows) const;

private:
    Compliance compliance_;
    Eigen::MatrixXd modes_;
    std::vector<FrictionRow> friction_;
    ActiveSet states_;
    double unit_;
    Unknowns unknowns_;
    SquareFactor factor_;
};

}  // namespace abut::solver
