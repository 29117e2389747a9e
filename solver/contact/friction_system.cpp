// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/friction_system.hpp"

#include <algorithm>

namespace abut::solver {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Unknowns unknowns_of(const ContactQp& qp, const ActiveSet& states) {
    Unknowns u{{}, std::vector<Index>(states.size(), -1)};
    for (std::size_t k = 0; k < states.size(); ++k) {
        if (states[k] != row_state::closed) continue;
        u.column[k] = static_cast<Index>(u.rows.size());
        u.rows.push_back(static_cast<Index>(k));
    }
    for (const FrictionRow& f : qp.friction)
        if (const double way = direction_of(states[index_of(f.tangential)]); way != 0 && u.column[index_of(f.normal)] >= 0)
            u.slips.push_back({f.tangential, u.column[index_of(f.normal)], -way * f.coefficient});
    return u;
}

double force_unit(const ContactQp& qp) {
    const double softest = qp.compliance.diagonal().maxCoeff();
    return softest > 0 ? 1 / softest : 1;
}

MatrixXd matrix_of(const ContactQp& qp, const MatrixXd& modes, const MatrixXd& stiffness, const Unknowns& u, double unit) {
    const Index m = static_cast<Index>(u.rows.size()), n = modes.cols();
    MatrixXd a(m + n, m + n);
    for (Index j = 0; j < m; ++j)
        for (Index i = 0; i < m; ++i) a(i, j) = unit * qp.compliance(u.rows[index_of(i)], u.rows[index_of(j)]);
    for (const Unknowns::Slip& s : u.slips)
        for (Index i = 0; i < m; ++i) a(i, s.column) += s.factor * unit * qp.compliance(u.rows[index_of(i)], s.tangential);
    if (n == 0) return a;
    for (Index j = 0; j < m; ++j) {
        a.row(j).tail(n) = modes.row(u.rows[index_of(j)]);
        a.col(j).tail(n) = a.row(j).tail(n).transpose();
    }
    for (const Unknowns::Slip& s : u.slips) a.col(s.column).tail(n) += s.factor * modes.row(s.tangential).transpose();
    a.bottomRightCorner(n, n) = -stiffness / unit;
    return a;
}

FrictionByRow friction_by_row(const ContactQp& qp) {
    FrictionByRow friction(qp.unilateral.size(), nullptr);
    for (const FrictionRow& f : qp.friction) friction[index_of(f.normal)] = friction[index_of(f.tangential)] = &f;
    return friction;
}

double left_of(Index row, const ActiveSet& states, const FrictionByRow& friction, const StatesPoint& p) {
    const char state = states[index_of(row)];
    if (state == row_state::closed) return p.opening[row];
    const double way = direction_of(state);
    const FrictionRow* f = friction[index_of(row)];
    return way == 0 ? p.forces[row] : p.forces[row] + way * f->coefficient * p.forces[f->normal];
}

FactoredStates::FactoredStates(const ContactQp& qp, const MatrixXd& stiffness, const ActiveSet& states)
    : compliance_(qp.compliance),
      modes_(qp.modes),
      friction_(qp.friction),
      states_(states),
      unit_(force_unit(qp)),
      unknowns_(unknowns_of(qp, states)),
      factor_(matrix_of(qp, qp.modes, stiffness, unknowns_, unit_)) {}

bool FactoredStates::is_of(const ContactQp& qp) const {
    const auto is_same = [](const FrictionRow& a, const FrictionRow& b) {
        return a.normal == b.normal && a.tangential == b.tangential && a.coefficient == b.coefficient;
    };
    return compliance_.shares(qp.compliance) && modes_ == qp.modes &&
           std::equal(friction_.begin(), friction_.end(), qp.friction.begin(), qp.friction.end(), is_same);
}

StatesPoint FactoredStates::answer(const VectorXd& rows, const VectorXd& amplitudes) const {
    StatesPoint p{rows, {}, {}};
    for (Index k : unknowns_.rows) p.forces[k] = 0;
    const Index m = static_cast<Index>(unknowns_.rows.size()), n = modes_.cols();
    VectorXd right(m + n);
    right.head(m) = rows(unknowns_.rows);
    right.tail(n) = amplitudes;
    if (!p.forces.isZero(0)) {
        right.head(m) -= unit_ * compliance_.product_at(unknowns_.rows, p.forces);
        right.tail(n) -= modes_.transpose() * p.forces;
    }
    const VectorXd x = factor_.solve(right);
    p.forces(unknowns_.rows) = x.head(m);
    for (const Unknowns::Slip& s : unknowns_.slips) p.forces[s.tangential] += s.factor * x[s.column];
    p.amplitudes = x.tail(n);
    return p;
}

void FactoredStates::fill_opening(StatesPoint& point) const {
    point.opening = unit_ * (compliance_ * point.forces) + modes_ * point.amplitudes;
}

void FactoredStates::fill_opening(StatesPoint& point, const std::vector<Index>& rows) const {
    point.opening.resize(point.forces.size());
    const VectorXd moved = modes_(rows, Eigen::all) * point.amplitudes;
    point.opening(rows) = unit_ * compliance_.product_at(rows, point.forces) + moved;
}

}  // namespace abut::solver
