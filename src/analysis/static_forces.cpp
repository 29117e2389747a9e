// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/static_forces.hpp"

#include <algorithm>

#include "geometry/curves/vec2.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "solver/parts/free_motions.hpp"
#include "src/solution/contact_measures.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

using Eigen::Index;

/// Singular values below this fraction of the largest one, and components of null vectors: zero.
constexpr double rounding = 1e-6;

struct Line {
    std::size_t contact;
    ContactForce unit;  ///< on the first part, of magnitude 1
};

/// What a unit force works in a part's free motion, lengths over the part's size.
double work(const ContactForce& unit, const PartOnGrid& g, const solver::RigidMotion& motion) {
    const Vec2 translation = g.frame.vector_to_global(motion.translation), center = g.frame.to_global(motion.center);
    return unit.force.dot(translation) + motion.rotation * (unit.moment - geometry::cross(center, unit.force));
}

/// Friction lets a contact's force turn: a unit force across it, through the middle of the face.
ContactForce across(const SolvedAssembly& solved, std::size_t contact) {
    const ContactForce force = contact_force(solved, contact);
    const solver::Interface& face = solved.contacts[contact].face;
    const Frame& frame = solved.grids[static_cast<std::size_t>(face.part[0])].frame;
    Vec2 middle(0, 0);
    for (const solver::InterfacePoint& p : face.points) middle += p.x[0] / static_cast<double>(face.points.size());
    const Vec2 unit = geometry::left_of(force.force.normalized());
    return {unit, geometry::cross(frame.to_global(middle), unit)};
}

/// What a support that holds a mean of a part works in the part's free motions.
Eigen::VectorXd work(const solver::MeanConstraint& c, const solver::PartSystem& part) {
    solver::Rows row;
    row.by_part.resize(1);
    append_mean_constraint(row, part, 0, c.integrals, c.area, c.coefficient, c.size, 0);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(part.modes.cols());
    for (const solver::RowEntry& e : row.by_part[0]) sum += e.value * part.modes.row(e.coefficient).transpose();
    return sum;
}

/// Contacts' forces as far as statics knows them: along their resultant, with friction also across it.
std::vector<Line> lines_of(const SolvedAssembly& solved) {
    std::vector<Line> lines;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        if (solved.interface_of[k] < 0) continue;
        ContactForce f = contact_force(solved, k);
        const double size = f.force.norm();
        if (!(size > 0)) continue;
        f.force /= size;
        f.moment /= size;
        lines.push_back({k, f});
        if (friction_of(solved, k) > 0) lines.push_back({k, across(solved, k)});
    }
    return lines;
}

/// What unit forces of lines and supports work in the free motions of parts: a row for each motion, a column for each force,
/// lines before supports.
Eigen::MatrixXd balance_of(const SolvedAssembly& solved, const std::vector<Line>& lines) {
    Index equations = 0;
    for (const solver::PartSystem& part : solved.problem.parts) equations += static_cast<Index>(part.free_motions.size());
    const std::vector<solver::MeanConstraint>& constraints = solved.problem.constraints;
    Eigen::MatrixXd balance = Eigen::MatrixXd::Zero(equations, static_cast<Index>(lines.size() + constraints.size()));
    Index row = 0;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const auto part = static_cast<int>(i);
        const std::vector<solver::RigidMotion>& motions = solved.problem.parts[i].free_motions;
        for (std::size_t k = 0; k < constraints.size(); ++k)
            if (constraints[k].part == part)
                balance.col(static_cast<Index>(lines.size() + k)).segment(row, static_cast<Index>(motions.size())) =
                    work(constraints[k], solved.problem.parts[i]);
        for (const solver::RigidMotion& motion : motions) {
            for (std::size_t j = 0; j < lines.size(); ++j) {
                const std::array<int, 2>& touches = solved.contacts[lines[j].contact].face.part;
                for (std::size_t side : {0U, 1U})
                    if (touches[side] == part)
                        balance(row, static_cast<Index>(j)) +=
                            (side == 0 ? 1 : -1) * work(lines[j].unit, solved.grids[i], motion);
            }
            ++row;
        }
    }
    return balance;
}

/// Contacts' lines of action may go as far as half their length.
void append_turns(const SolvedAssembly& solved, std::vector<Line>& lines) {
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        if (solved.interface_of[k] >= 0 && !solved.stretches[k].empty())
            lines.push_back({k, {Vec2(0, 0), 0.5 * (solved.stretches[k].back().end - solved.stretches[k].front().begin)}});
}

/// The combinations of forces that balance by themselves, orthonormal columns: what statics does not know.
Eigen::MatrixXd left_open(const Eigen::MatrixXd& balance) {
    if (balance.rows() == 0 || balance.cols() == 0) return Eigen::MatrixXd::Identity(balance.cols(), balance.cols());
    const auto [values, vectors] = solver::right_singular_vectors(balance);
    const Index rank = (values.array() > rounding * values[0]).count();
    return vectors.rightCols(balance.cols() - rank);
}

}  // namespace

std::vector<char> given_by_statics(const SolvedAssembly& solved) {
    const std::vector<Line> lines = lines_of(solved);
    const Eigen::MatrixXd balance = balance_of(solved, lines);
    std::vector<char> given(solved.contacts.size(), 0);
    if (balance.rows() == 0 || lines.empty()) return given;
    const Eigen::MatrixXd open = left_open(balance);
    for (const Line& line : lines) given[line.contact] = 1;
    for (std::size_t j = 0; j < lines.size(); ++j)
        if (open.row(static_cast<Index>(j)).norm() >= rounding) given[lines[j].contact] = 0;
    return given;
}

std::vector<double> shared_with_contacts(const SolvedAssembly& solved) {
    std::vector<Line> lines = lines_of(solved);
    append_turns(solved, lines);
    const Eigen::MatrixXd open = left_open(balance_of(solved, lines));
    const auto n = static_cast<Index>(lines.size());
    const Eigen::MatrixXd shared = open.bottomRows(open.rows() - n) * open.topRows(n).transpose();
    std::vector<double> most;
    for (Index k = 0; k < shared.rows(); ++k) most.push_back(n == 0 ? 0 : shared.row(k).cwiseAbs().maxCoeff());
    return most;
}

Eigen::MatrixXd combinations_let_go(const SolvedAssembly& solved, std::size_t grid, bool are_led_free) {
    const solver::PartSystem& part = solved.problem.parts[grid];
    const auto n = static_cast<Index>(part.free_motions.size());
    Eigen::MatrixXd held(0, n);
    for (const solver::MeanConstraint& c : solved.problem.constraints) {
        if (c.part != static_cast<int>(grid) || (are_led_free && c.value != 0)) continue;
        held.conservativeResize(held.rows() + 1, n);
        held.row(held.rows() - 1) = work(c, part).normalized();
    }
    if (held.rows() == 0) return Eigen::MatrixXd::Identity(n, n);
    const auto [values, vectors] = solver::right_singular_vectors(held);
    const Index rank = (values.array() > rounding * values[0]).count();
    return vectors.rightCols(n - rank);
}

std::vector<solver::RigidMotion> motions_left_to_contacts(const SolvedAssembly& solved, std::size_t grid) {
    const std::vector<solver::RigidMotion>& free = solved.problem.parts[grid].free_motions;
    if (free.empty() || !has_held_means(solved, grid)) return free;
    const Eigen::MatrixXd combined = combinations_let_go(solved, grid, false);
    std::vector<solver::RigidMotion> left;
    for (Index k = 0; k < combined.cols(); ++k) left.push_back(solver::sum_of_motions(free, combined.col(k)));
    return left;
}

bool has_held_means(const SolvedAssembly& solved, std::size_t grid) {
    return std::any_of(solved.problem.constraints.begin(), solved.problem.constraints.end(),
                       [&](const solver::MeanConstraint& c) { return c.part == static_cast<int>(grid); });
}

}  // namespace abut
