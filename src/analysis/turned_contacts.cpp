// SPDX-License-Identifier: GPL-3.0-or-later
// Small displacements balance forces where parts are drawn. Here they are balanced once more, by statics, where the solution
// has put the parts: the lines of action turn with their faces and move with their points, dead loads act where they have gone,
// and the shortest change of the forces that balances all this is what the answer leaves out.
//
// Where forces have gone: moved_forces.cpp. A contact that moves along as its body rolls, while loads stay, balances a moment
// that it does not have: what loads do in a motion in which no contact force could work where the parts were drawn is balanced
// by nothing.
//
// Motions in which no force can work (bodies roll on each other) are pushed: loads and forces that work in them then, and not
// against them, take them farther.
#include "src/analysis/turned_contacts.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "solver/linear_algebra/dense.hpp"
#include "solver/parts/free_motions.hpp"
#include "src/analysis/lever_changes.hpp"
#include "src/analysis/moved_forces.hpp"
#include "src/analysis/placement.hpp"
#include "src/analysis/static_forces.hpp"
#include "src/answers/motion_text.hpp"
#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"
#include "src/solution/contact_measures.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

using Eigen::Index;
using geometry::cross, geometry::left_of;

/// Forces are known to about a tenth of what pressures are.
constexpr double noted_turn = 0.5;             // of the target
constexpr double rounding_of_pressing = 1e-9;  // what is left of resultants that cancel
/// The system that forces balance in: a row for every free motion of a part that nothing but contacts holds in it.
struct Balance {
    std::vector<std::size_t> part;            ///< by row: among the grids
    std::vector<solver::RigidMotion> motion;  ///< by row, in assembly coordinates
};

Balance balance_of(const SolvedAssembly& solved) {
    Balance b;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const Frame& frame = solved.grids[i].frame;
        for (const solver::RigidMotion& m : motions_left_to_contacts(solved, i)) {
            b.part.push_back(i);
            b.motion.push_back({frame.vector_to_global(m.translation), m.rotation, frame.to_global(m.center)});
        }
    }
    return b;
}

/// What a force on a contact's first part, and its opposite on the second, work in a row's motion.
double work_in_row(const SolvedAssembly& solved, const Balance& b, std::size_t row, std::size_t contact, const Vec2& place,
                   const Vec2& force) {
    const std::array<int, 2>& part = solved.contacts[contact].face.part;
    double sum = 0;
    for (int side : {0, 1})
        if (at(part[at(side)]) == b.part[row]) sum += (side == 0 ? 1 : -1) * force.dot(b.motion[row].at(place));
    return sum;
}

/// What a part's loads work in a row's motion.
double load_work(const SolvedAssembly& solved, const Balance& b, std::size_t row) {
    const std::size_t i = b.part[row];
    const solver::PartSystem& part = solved.problem.parts[i];
    const solver::Resultant total = resultant_of(part.input.space, part.applied);
    const Vec2 center = solved.grids[i].frame.to_local(b.motion[row].center);
    return solved.grids[i].frame.vector_to_global(total.force).dot(b.motion[row].translation) +
           b.motion[row].rotation * (total.moment - cross(center, total.force));
}

/// How much more a part's dead loads work in a row's motion once they act where the part has gone.
double load_change(const SolvedAssembly& solved, const Balance& b, std::size_t row, const solver::RigidMotion& moved) {
    const std::size_t i = b.part[row];
    const solver::PartSystem& part = solved.problem.parts[i];
    const double virial = virial_of(part.input.space, part.applied, solved.grids[i].frame.to_local(moved.center));
    const Vec2 force = solved.grids[i].frame.vector_to_global(resultant_of(part.input.space, part.applied).force);
    return b.motion[row].rotation * (cross(moved.translation, force) - moved.rotation * virial);
}

/// What a line's force can be besides what it is.
struct Unknown {
    std::size_t line;
    Vec2 direction;  ///< zero: a couple
};

std::vector<Unknown> unknowns_of(const std::vector<MovedForce>& lines) {
    std::vector<Unknown> unknowns;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const Vec2 direction = lines[k].force.norm() > 0 ? lines[k].force.normalized() : Vec2(1, 0);
        unknowns.push_back({k, direction});
        if (lines[k].any_direction) unknowns.push_back({k, left_of(direction)});
        if (lines[k].any_place) unknowns.push_back({k, {0, 0}});
    }
    return unknowns;
}

/// By row, what each unknown works. By the places as drawn: the same to the first order, and what works nothing in a motion
/// does so here.
Eigen::MatrixXd works_of(const SolvedAssembly& solved, const Balance& b, const std::vector<MovedForce>& lines,
                         const std::vector<Unknown>& unknowns) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Index>(b.part.size()), static_cast<Index>(unknowns.size()));
    for (std::size_t row = 0; row < b.part.size(); ++row)
        for (std::size_t j = 0; j < unknowns.size(); ++j) {
            const MovedForce& l = lines[unknowns[j].line];
            const Vec2 &direction = unknowns[j].direction, place = l.drawn + l.along;
            const Vec2 aside(solved.grids[b.part[row]].size, 0);
            // a couple at the part's size: a force there and its opposite at the line
            matrix(static_cast<Index>(row), static_cast<Index>(j)) =
                direction.norm() > 0 ? work_in_row(solved, b, row, l.contact, place, direction)
                                     : work_in_row(solved, b, row, l.contact, place + aside, {0, 1}) -
                                           work_in_row(solved, b, row, l.contact, place, {0, 1});
        }
    return matrix;
}

/// By row, what the lines' forces and the loads do more where parts have gone.
Eigen::VectorXd off_balance(const SolvedAssembly& solved, const Balance& b, const std::vector<MovedForce>& lines,
                            const std::vector<solver::RigidMotion>& motions) {
    Eigen::VectorXd off(static_cast<Index>(b.part.size()));
    for (std::size_t row = 0; row < b.part.size(); ++row) {
        double& sum = off[static_cast<Index>(row)] = load_change(solved, b, row, motions[b.part[row]]);
        for (const MovedForce& l : lines)
            sum += work_in_row(solved, b, row, l.contact, l.moved, l.turned) -
                   work_in_row(solved, b, row, l.contact, l.drawn, l.force);
    }
    return off;
}

Index rank_of(const Eigen::VectorXd& values) {
    Index rank = 0;
    while (rank < values.size() && values[rank] > known_places * values[0]) ++rank;
    return rank;
}

/// Changes of the lines' forces on their first parts that balance them where parts have gone, with those of `turned`; and by
/// row what they leave out of balance, and what loads do in motions in which no force of a contact would work as drawn.
struct Rebalanced {
    std::vector<Vec2> change;
    Eigen::VectorXd left, driven;
};

Rebalanced rebalanced(const SolvedAssembly& solved, const Balance& b, const std::vector<MovedForce>& lines,
                      const std::vector<solver::RigidMotion>& motions) {
    const std::vector<Unknown> unknowns = unknowns_of(lines);
    const Eigen::MatrixXd matrix = works_of(solved, b, lines, unknowns);
    const Eigen::VectorXd off = off_balance(solved, b, lines, motions);
    Eigen::VectorXd loads(off.size());
    for (std::size_t row = 0; row < b.part.size(); ++row) loads[static_cast<Index>(row)] = load_work(solved, b, row);
    const auto [values, vectors] = solver::right_singular_vectors(matrix);
    const Index rank = rank_of(values);
    const auto range = vectors.leftCols(rank);
    const auto balancing = [&](const Eigen::VectorXd& work) -> Eigen::VectorXd {
        const Eigen::VectorXd along_range = range.transpose() * (matrix.transpose() * work);
        return -(range * along_range.cwiseQuotient(values.head(rank).cwiseAbs2()));
    };
    const Eigen::VectorXd change = balancing(off);
    Rebalanced result{std::vector<Vec2>(lines.size()), off + matrix * change, loads + matrix * balancing(loads)};
    for (std::size_t k = 0; k < lines.size(); ++k) result.change[k] = lines[k].turned - lines[k].force;
    for (std::size_t j = 0; j < unknowns.size(); ++j)
        result.change[unknowns[j].line] += change[static_cast<Index>(j)] * unknowns[j].direction;
    return result;
}

/// By how much more than it can friction would have to bear in a contact where parts have moved to, as a share.
double beyond_friction(const SolvedAssembly& solved, const MovedForce& line, const Vec2& change) {
    const double friction = friction_of(solved, line.contact);
    if (friction == 0 || line.normal.norm() == 0) return 0;
    const Vec2 force = line.force + change;
    return std::abs(cross(line.normal, force)) / (friction * std::abs(line.normal.dot(force))) - 1;
}

/// The share of what drives a part that nothing balances where the part has gone; 0: nothing that counts beside how well the
/// places of its contacts' forces are known drives it.
double share_not_held(const SolvedAssembly& solved, const Balance& b, const std::vector<MovedForce>& lines,
                      const Rebalanced& moved, std::size_t part) {
    double known = 0, driven = 0, left = 0;
    for (const MovedForce& l : lines)
        for (const int side : {0, 1})
            if (at(solved.contacts[l.contact].face.part[at(side)]) == part)
                known += known_within_contact * 0.5 * length_of(solved.stretches[l.contact]) * l.force.norm();
    for (std::size_t row = 0; row < b.part.size(); ++row) {
        if (b.part[row] != part) continue;
        const auto r = static_cast<Index>(row);
        driven = std::hypot(driven, moved.driven[r]);
        left = std::hypot(left, moved.left[r]);
    }
    const double cancelling = solver::neutral_work_fraction * solved.problem.part_load[part];
    return driven > std::max(known / solved.grids[part].size, cancelling) ? std::min(1.0, left / driven) : 0;
}

/// What is balanced, by which forces, where their parts have gone.
struct Turned {
    Balance balance;
    std::vector<solver::RigidMotion> motions;
    std::vector<MovedForce> lines;
};

Turned turned_of(const Scene& scene, const SolvedAssembly& solved) {
    Turned turned{balance_of(solved), {}, {}};
    for (std::size_t i = 0; i < solved.grids.size(); ++i) turned.motions.push_back(rigid_motion_of(solved, i));
    turned.lines = moved_forces(scene, solved, turned.motions);
    return turned;
}

bool has_resultant(const SolvedAssembly& solved, const MovedForce& line) {
    return line.force.norm() > rounding_of_pressing * pressing_force(solved, line.contact);
}

/// The motions of parts under `share` of a motion of the rows, beside those that they have.
std::vector<solver::RigidMotion> moved_on(const Balance& b, const Eigen::VectorXd& motion, double share,
                                          std::vector<solver::RigidMotion> motions) {
    for (std::size_t row = 0; row < b.part.size(); ++row) {
        solver::RigidMotion& of_part = motions[b.part[row]];
        const double amplitude = share * motion[static_cast<Index>(row)];
        of_part.translation += amplitude * b.motion[row].at(of_part.center);
        of_part.rotation += amplitude * b.motion[row].rotation;
    }
    return motions;
}

double largest_force(const std::vector<MovedForce>& lines) {
    double largest = 0;
    for (const MovedForce& l : lines) largest = std::max(largest, l.force.norm());
    return largest;
}

/// The motion of the rows in which no contact holds the parts, rolling on each other, and in which they go on by themselves,
/// the fastest of them; empty: none. Friction holds what turns in a hollow face.
Eigen::VectorXd unstable_motion(const Scene& scene, const SolvedAssembly& solved, const Turned& turned) {
    constexpr double push = 1e-5;  // radians
    const Balance& b = turned.balance;
    std::vector<Unknown> unknowns = unknowns_of(turned.lines);
    for (std::size_t k = 0; k < turned.lines.size(); ++k)
        if (turned.lines[k].normal.norm() == 0 && friction_of(solved, turned.lines[k].contact) > 0)
            unknowns.push_back({k, {0, 0}});
    const Eigen::MatrixXd works = works_of(solved, b, turned.lines, unknowns);
    const auto [values, vectors] = solver::right_singular_vectors(works.transpose());
    const Eigen::MatrixXd rolling = vectors.rightCols(works.rows() - rank_of(values));
    if (rolling.cols() == 0) return {};
    Eigen::MatrixXd driving(rolling.cols(), rolling.cols());
    double turn = 0;  // sizes times squared rotations, of the one that turns most
    for (Index k = 0; k < rolling.cols(); ++k) {
        double fastest = 0;
        for (std::size_t row = 0; row < b.part.size(); ++row) {
            const double rotation = std::abs(rolling(static_cast<Index>(row), k) * b.motion[row].rotation);
            fastest = std::max(fastest, rotation);
            turn = std::max(turn, solved.grids[b.part[row]].size * rotation * rotation);
        }
        if (fastest == 0) return {};
        const auto off = [&](double share) {
            const auto motions = moved_on(b, rolling.col(k), share / fastest, turned.motions);
            return off_balance(solved, b, moved_forces(scene, solved, motions), motions);
        };
        driving.col(k) = rolling.transpose() * (off(push) - off(-push)) / (2 * push / fastest);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (driving + driving.transpose()));
    const Index most = driving.cols() - 1;
    if (!(eigen.eigenvalues()[most] > known_places * largest_force(turned.lines) * turn)) return {};
    return rolling * eigen.eigenvectors().col(most);
}

}  // namespace

void warn_of_unstable_balance(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    const Turned turned = turned_of(scene, solved);
    if (turned.balance.part.empty() || std::none_of(turned.lines.begin(), turned.lines.end(),
                                                    [&](const MovedForce& l) { return friction_of(solved, l.contact) > 0; }))
        return;  // what slides freely was pushed where it was put
    const Eigen::VectorXd motion = unstable_motion(scene, solved, turned);
    std::vector<Finding> findings;
    for (std::size_t i = 0; motion.size() > 0 && i < solved.grids.size(); ++i) {
        const std::vector<solver::RigidMotion> free = motions_left_to_contacts(solved, i);
        const auto first = std::find(turned.balance.part.begin(), turned.balance.part.end(), i);
        if (first == turned.balance.part.end()) continue;
        const Eigen::VectorXd own = motion.segment(first - turned.balance.part.begin(), static_cast<Index>(free.size()));
        if (own.norm() <= known_places * motion.norm()) continue;
        const std::string text = "the balance is unstable: once pushed, " +
                                 motion_text(scene, solved, {static_cast<int>(i), solver::sum_of_motions(free, own)}) +
                                 " and goes on";
        findings.push_back({own.norm(), scene.parts[at(solved.grids[i].part)].name,
                            text + ", rolling, which friction does not hold: this is the answer as long as nothing pushes",
                            text});
    }
    tell(std::move(findings), "turned_balance", result);
}

bool are_forces_turned(const Scene& scene, const Outcome& out) {
    const Turned turned = turned_of(scene, out.solved);
    const auto& [balance, motions, lines] = turned;
    if (lines.empty()) return false;
    for (const LeverChange& lever : lever_changes(scene, out.solved))
        if (lever.share > noted_turn * out.target) return true;
    if (balance.part.empty()) return false;
    const Rebalanced moved = rebalanced(out.solved, balance, lines, motions);
    double largest = 0, most = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        largest = std::max(largest, lines[k].force.norm());
        most = std::max(most, moved.change[k].norm());
    }
    return most > noted_turn * out.target * largest;
}

bool do_parts_go_on(const Scene& scene, const SolvedAssembly& solved) {
    constexpr double most = 0.5;  // of what drives a part
    const auto [balance, motions, lines] = turned_of(scene, solved);
    if (lines.empty() || balance.part.empty()) return false;
    const Rebalanced moved = rebalanced(solved, balance, lines, motions);
    for (std::size_t i = 0; i < solved.grids.size(); ++i)
        if (share_not_held(solved, balance, lines, moved, i) > most) return true;
    return false;
}

std::vector<double> turned_shares(const Scene& scene, const SolvedAssembly& solved) {
    std::vector<double> shares(solved.contacts.size(), 0);
    const auto [balance, motions, lines] = turned_of(scene, solved);
    if (lines.empty() || balance.part.empty()) return shares;
    const Rebalanced moved = rebalanced(solved, balance, lines, motions);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        double& share = shares[lines[k].contact];
        if (!solved.contacts[lines[k].contact].face.bilateral && has_resultant(solved, lines[k]))
            share = std::max(share, std::min(1.0, moved.change[k].norm() / lines[k].force.norm()));
    }
    return shares;
}

void warn_of_turned_contacts(const Scene& scene, const Outcome& out, Result& result) {
    const SolvedAssembly& solved = out.solved;
    const Turned turned = turned_of(scene, solved);
    const auto& [balance, motions, lines] = turned;
    // press fits, which press all round, have no resultant
    if (std::none_of(lines.begin(), lines.end(), [&](const MovedForce& l) { return has_resultant(solved, l); })) return;
    const double noted = noted_turn * out.target;
    const std::string advice = "; draw the parts nearer to where they come to rest";
    std::vector<Finding> forces, frictions, motions_left, levers;
    const std::vector<LeverChange> changes = lever_changes(scene, solved);
    for (std::size_t i = 0; i < changes.size(); ++i) {
        const double share = changes[i].share;
        if (share <= noted) continue;
        const std::string &name = scene.parts[at(solved.grids[i].part)].name,
                          text = changes[i].of_moment ? "the moment of the contacts' forces on " + name + " changes by " +
                                                            percent_text(share) + " as parts move"
                                                      : "the contacts' forces on " + name + " move by " + percent_text(share) +
                                                            " of its size as parts do";
        levers.push_back({share, name, text + ", which the answer leaves out", text});
    }
    tell(std::move(levers), "turned_lever", result);
    if (balance.part.empty()) return;
    const double largest = largest_force(lines);
    const Rebalanced moved = rebalanced(solved, balance, lines, motions);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const std::string number = contact_number(lines[k].contact);
        if (const double share = moved.change[k].norm() / largest; share > noted) {
            const std::string text =
                "the force of contact " + number + " changes by " + percent_text(share) + " of the largest one as parts move";
            forces.push_back({share, "contact " + number,
                              text + ", which the answer leaves out: forces may be off by more than their errors say" + advice,
                              text});
        }
        const bool carries = (lines[k].force + moved.change[k]).norm() > noted * largest;
        if (const double share = beyond_friction(solved, lines[k], moved.change[k]); carries && share > noted) {
            const std::string text = "where parts have moved to, friction in contact " + number + " would have to bear " +
                                     percent_text(share) + " more than it can";
            frictions.push_back({share, "contact " + number, text + advice, text});
        }
    }
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const std::string& name = scene.parts[at(solved.grids[i].part)].name;
        double share = 0;
        for (std::size_t row = 0; row < balance.part.size(); ++row)
            if (balance.part[row] == i) share = std::max(share, std::abs(moved.left[static_cast<Index>(row)]) / largest);
        if (const double rolling = share_not_held(solved, balance, lines, moved, i); rolling > noted) {
            const std::string text = "part " + name + " is driven by its loads in a motion in which " + percent_text(rolling) +
                                     " of them is not balanced where it has moved to";
            motions_left.push_back({rolling, name,
                                    text + ": it rolls or slides on, and only contact that small displacements move along with "
                                           "it while its loads stay seems to hold it. Balance these loads, or support it",
                                    text});
        } else if (share > noted) {
            const std::string text = "where part " + name + " has moved to, " + percent_text(share) +
                                     " of the largest contact force is not balanced";
            motions_left.push_back({share, name, text + ": it may go on moving" + advice, text});
        }
    }
    tell(std::move(forces), "turned_force", result);
    tell(std::move(motions_left), "turned_balance", result);
    tell(std::move(frictions), "turned_lever", result);
}

}  // namespace abut
