// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/interfaces/screw.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

using Eigen::MatrixXd;

/// Wrenches about the scale's centre, moments in units of force times size.
Screw local_wrench(const Screw& w, const ScrewScale& scale) {
    return {w[0], w[1], (w[2] - cross(scale.center, Vec2(w[0], w[1]))) / scale.size};
}

/// Twists of the point at the scale's centre, rotations times size: so that work is the plain product with a local wrench.
Screw local_twist(const Screw& t, const ScrewScale& scale) {
    return {t[0] - t[2] * scale.center.y(), t[1] + t[2] * scale.center.x(), t[2] * scale.size};
}

Screw global_twist(const Screw& t, const ScrewScale& scale) {
    const double w = t[2] / scale.size;
    return {t[0] + w * scale.center.y(), t[1] - w * scale.center.x(), w};
}

Screw global_wrench(const Screw& w, const ScrewScale& scale) {
    return {w[0], w[1], w[2] * scale.size + cross(scale.center, Vec2(w[0], w[1]))};
}

struct Spaces {
    MatrixXd range, null;  ///< orthonormal columns
};

/// Range of the columns of m, and what is orthogonal to all of them.
Spaces spaces_of(const MatrixXd& m) {
    const Eigen::Index n = m.rows();
    if (m.cols() == 0) return {MatrixXd(n, 0), MatrixXd::Identity(n, n)};
    const Eigen::JacobiSVD<MatrixXd> svd(m, Eigen::ComputeFullU);
    const auto& values = svd.singularValues();
    Eigen::Index rank = 0;
    while (rank < values.size() && values[rank] > screw_rank_fraction * values[0]) ++rank;
    return {svd.matrixU().leftCols(rank), svd.matrixU().rightCols(n - rank)};
}

MatrixXd columns(const std::vector<Screw>& screws, Screw (*local)(const Screw&, const ScrewScale&), const ScrewScale& scale) {
    MatrixXd m(3, static_cast<Eigen::Index>(screws.size()));
    // of unit size: a couple of one is small beside a force where lengths are large numbers, and no less a wrench
    for (std::size_t k = 0; k < screws.size(); ++k)
        m.col(static_cast<Eigen::Index>(k)) = local(screws[k], scale).stableNormalized();
    return m;
}

/// Direction with a sign that does not depend on rounding: the larger component positive.
Vec2 oriented(const Vec2& d) {
    const double leading = std::abs(d.x()) + screw_rank_fraction >= std::abs(d.y()) ? d.x() : d.y();
    return (leading < 0 ? -d : d).normalized();
}

/// What the products of coordinates above leave of zeros: unit vectors to this, arms to this in the scale's size.
constexpr double rounding = 1e-12;

/// Rounding taken out: reads as 0. Forces and directions are of unit size; arms in units of length.
double tidy(double v, double size) {
    return std::abs(v) <= rounding * size ? 0.0 : v;
}
Vec2 tidy(const Vec2& d, double size) {
    return {tidy(d.x(), size), tidy(d.y(), size)};
}

/// Size of numbers that an arm is the difference of.
double arm_size(const ScrewScale& scale) {
    return scale.size + scale.center.norm();
}

/// Does the space hold the pure moment (rotation about the centre)? Then the rest of it has none.
bool holds_moment(const MatrixXd& space) {
    return space.cols() > 0 && (Screw::UnitZ() - space * (space.transpose() * Screw::UnitZ())).norm() <= screw_rank_fraction;
}

/// Directions of the first two components of a space, orthonormal; (1, 0) and (0, 1) if there are two.
MatrixXd directions(const MatrixXd& space) {
    const MatrixXd d = spaces_of(space.topRows(2)).range;
    return d.cols() == 2 ? MatrixXd(MatrixXd::Identity(2, 2)) : d;
}

}  // namespace

std::vector<Screw> wrench_space(const std::vector<Screw>& wrenches, const ScrewScale& scale) {
    ENSURE(scale.size > 0, "moments are measured in a length");
    const MatrixXd space = spaces_of(columns(wrenches, local_wrench, scale)).range;
    const bool moment = holds_moment(space);
    std::vector<Screw> basis;
    const MatrixXd forces = directions(space);
    for (Eigen::Index k = 0; k < forces.cols() && static_cast<Eigen::Index>(basis.size()) < space.cols() - moment; ++k) {
        const Vec2 f = tidy(oriented(forces.col(k)), 1);
        // the member of the space with this force
        const Eigen::VectorXd c = space.topRows(2).completeOrthogonalDecomposition().solve(f);
        const double arm = moment ? 0.0 : (space.row(2) * c).value();
        const Screw w = global_wrench({f.x(), f.y(), arm}, scale);
        basis.emplace_back(w[0], w[1], moment ? 0.0 : tidy(w[2], arm_size(scale)));
    }
    if (moment) basis.push_back(Screw::UnitZ());
    return basis;
}

std::vector<Screw> span_of_twists(const std::vector<Screw>& twists, const ScrewScale& scale) {
    const MatrixXd space = spaces_of(columns(twists, local_twist, scale)).range;
    const Eigen::Index n = space.cols();
    // translations: the part of the space without rotation
    const MatrixXd still = n == 0 ? MatrixXd(0, 0) : MatrixXd(spaces_of(space.row(2).transpose()).null);
    const bool turns = n > 0 && space.row(2).norm() > screw_rank_fraction;
    const MatrixXd slides = directions(turns ? MatrixXd(space * still) : space);
    std::vector<Screw> basis;
    if (turns) {
        const Screw about = space * (space.row(2).transpose() / space.row(2).squaredNorm());
        Screw twist = global_twist(about * scale.size, scale);
        Vec2 v(twist[0], twist[1]);
        for (Eigen::Index k = 0; k < slides.cols(); ++k) v -= v.dot(Vec2(slides.col(k))) * Vec2(slides.col(k));
        v = tidy(v, arm_size(scale));
        basis.emplace_back(v.x(), v.y(), 1);
    }
    for (Eigen::Index k = 0; k < slides.cols(); ++k) {
        const Vec2 d = tidy(oriented(slides.col(k)), 1);
        basis.emplace_back(d.x(), d.y(), 0);
    }
    return basis;
}

std::vector<Screw> twist_space(const std::vector<Screw>& wrenches, const ScrewScale& scale) {
    ENSURE(scale.size > 0, "moments are measured in a length");
    const MatrixXd null = spaces_of(columns(wrenches, local_wrench, scale)).null;
    std::vector<Screw> twists;
    for (Eigen::Index k = 0; k < null.cols(); ++k) twists.push_back(global_twist(null.col(k), scale));
    return span_of_twists(twists, scale);
}

Mobility mobility(int n_bodies, const std::vector<Connection>& connections, const ScrewScale& scale) {
    ENSURE(n_bodies >= 0 && scale.size > 0, "moments are measured in a length");
    ENSURE(std::all_of(
               connections.begin(), connections.end(),
               [&](const Connection& c) { return c.body >= 0 && c.body < n_bodies && c.other >= -1 && c.other < n_bodies; }),
           "connections are of the bodies");
    MatrixXd m = MatrixXd::Zero(3 * n_bodies, static_cast<Eigen::Index>(connections.size()));
    for (std::size_t k = 0; k < connections.size(); ++k) {
        const Connection& c = connections[k];
        const Screw w = local_wrench(c.wrench, scale).stableNormalized();
        m.col(static_cast<Eigen::Index>(k)).segment<3>(3 * c.body) += w;
        if (c.other >= 0) m.col(static_cast<Eigen::Index>(k)).segment<3>(3 * c.other) -= w;
    }
    const MatrixXd null = spaces_of(m).null;
    Mobility result;
    const auto n_connections = static_cast<int>(connections.size());
    result.degrees_of_freedom = static_cast<int>(null.cols());
    result.gruebler = 3 * n_bodies - n_connections;
    result.redundant = result.degrees_of_freedom - result.gruebler;
    for (int body = 0; body < n_bodies; ++body) {
        std::vector<Screw> twists;
        for (Eigen::Index k = 0; k < null.cols(); ++k)
            if (null.col(k).segment<3>(3 * body).norm() > screw_rank_fraction)
                twists.push_back(global_twist(null.col(k).segment<3>(3 * body), scale));
        result.free.push_back(span_of_twists(twists, scale));
    }
    return result;
}

}  // namespace abut::geometry
