// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/friction_system.hpp"

namespace abut::solver {

using Eigen::Index;
using Eigen::MatrixXd;

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

}  // namespace abut::solver
