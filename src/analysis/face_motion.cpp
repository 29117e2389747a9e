// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/face_motion.hpp"

#include "geometry/curves/vec2.hpp"
#include "solver/contact/interface.hpp"
#include "src/analysis/placement.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

using geometry::cross, geometry::left_of;

/// One side of a contact, with its moments, in its part's frame.
struct FaceSide {
    const solver::Interface& face;
    std::size_t side, part;
    Vec2 middle{0, 0};
    double length = 0, inertia = 0;

    const Vec2& place(const solver::InterfacePoint& p) const { return p.x[side]; }
};

FaceSide side_of(const SolvedAssembly& solved, std::size_t contact, std::size_t side) {
    ENSURE(solved.interface_of[contact] >= 0, "the contact is coupled");
    const solver::Interface& face = solved.problem.interfaces[at(solved.interface_of[contact])];
    FaceSide own{face, side, at(face.part[side])};
    for (const solver::InterfacePoint& p : face.points) {
        own.length += p.weight;
        own.middle += p.weight * own.place(p);
    }
    own.middle /= own.length;
    for (const solver::InterfacePoint& p : face.points) own.inertia += p.weight * (own.place(p) - own.middle).squaredNorm();
    return own;
}

}  // namespace

solver::RigidMotion face_motion(const SolvedAssembly& solved, std::size_t contact, std::size_t side) {
    const FaceSide own = side_of(solved, contact, side);
    const PartOnGrid& grid = solved.grids[own.part];
    if (grid.input.axis) return rigid_motion_of(solved, own.part);
    Vec2 translation(0, 0);
    double turning = 0;
    for (const solver::InterfacePoint& p : own.face.points) {
        const Vec2 u = displacement_at(grid.input, solved.solution.displacement[own.part], p.element[side], own.place(p)).value;
        translation += p.weight / own.length * u;
        turning += p.weight * cross(own.place(p) - own.middle, u);
    }
    return {grid.frame.vector_to_global(translation), turning / own.inertia, grid.frame.to_global(own.middle)};
}

Eigen::VectorXd load_on_face(const SolvedAssembly& solved, std::size_t contact, std::size_t side, const Vec2& force,
                             double moment, const Vec2& about) {
    const FaceSide own = side_of(solved, contact, side);
    const PartOnGrid& grid = solved.grids[own.part];
    const Vec2 local = grid.frame.vector_to_local(force);
    const double turning = moment + cross(grid.frame.to_local(about) - own.middle, local), thickness = grid.input.thickness;
    std::vector<solver::TractionPoint> points;
    for (const solver::InterfacePoint& p : own.face.points)
        points.push_back(
            {p.element[side], own.place(p), p.weight,
             local / (own.length * thickness) + turning / (own.inertia * thickness) * left_of(own.place(p) - own.middle)});
    return solver::boundary_load(grid.input, points);
}

}  // namespace abut
