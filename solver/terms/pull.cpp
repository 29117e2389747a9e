// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/pull.hpp"

#include "src/base/ensure.hpp"

namespace abut::solver {

Pull make_pull(const BlockMatrix& stiffness, Eigen::VectorXd displacement) {
    Pull pull{std::move(displacement), {}, 0, 0};
    pull.load = multiply(stiffness, pull.displacement);
    pull.stiffness = pull.displacement.dot(pull.load);
    ENSURE(pull.stiffness > 0, "a pull strains the part across its cut");
    return pull;
}

double force_across(const Pull& pull, const Eigen::VectorXd& u, const Eigen::VectorXd& free_strain) {
    return pull.stiffness * pull.shortening - pull.load.dot(u) +
           (free_strain.size() > 0 ? pull.displacement.dot(free_strain) : 0);
}

}  // namespace abut::solver
