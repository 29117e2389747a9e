// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/face_motion.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/vec2.hpp"
#include "solver/contact/interface.hpp"
#include "src/analysis/placement.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/solution/contact_measures.hpp"

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

/// What the faces press into each other by: of a line contact of half width b p b / E* (2 ln(L / b) + 1), at places L from it
/// [Johnson85, section 5.6].
double indentation_of(const SolvedAssembly& solved, std::size_t contact) {
    constexpr double at_places = 10;  // of L / b up to 90
    double width = 0;
    for (const PressedStretch& stretch : solved.stretches[contact]) width = std::max(width, stretch.end - stretch.begin);
    if (width == 0) return 0;
    return at_places * 0.5 * width * compliance_of(solved, contact) * pressure_of(solved, contact).maxCoeff();
}

/// Do supports hold the side along the face at this end, by which the next point of the face is `next`?
bool is_held_along(const solver::PartSystem& part, const Vec2& end, const Vec2& next, double length) {
    constexpr double near = 0.25, along_face = 0.9;  // of the face's length: points of supports are cells apart; cosine
    const Vec2 along = (next - end).normalized();
    for (const solver::SupportRecord& record : part.supports)
        for (const solver::SupportPoint& p : record.set.points)
            if ((p.x - end).norm() <= near * length && std::abs(p.direction.dot(along)) >= along_face) return true;
    return false;
}

}  // namespace

bool ends_at_mirror(const SolvedAssembly& solved, std::size_t contact) {
    for (const std::size_t side : {0U, 1U}) {
        const FaceSide own = side_of(solved, contact, side);
        const std::vector<solver::InterfacePoint>& points = own.face.points;
        const std::size_t n = points.size();
        const solver::PartSystem& part = solved.problem.parts[own.part];
        if (n > 1 && (is_held_along(part, own.place(points[0]), own.place(points[1]), own.length) ||
                      is_held_along(part, own.place(points[n - 1]), own.place(points[n - 2]), own.length)))
            return true;
    }
    return false;
}

solver::RigidMotion face_motion(const SolvedAssembly& solved, std::size_t contact, std::size_t side) {
    const FaceSide own = side_of(solved, contact, side);
    const PartOnGrid& grid = solved.grids[own.part];
    if (grid.input.axis) return rigid_motion_of(solved, own.part);
    const bool is_held = !solved.problem.parts[own.part].supports.empty();  // by edges: it bends, and may be half a part
    solver::RigidMotion motion{{0, 0}, 0, grid.frame.to_global(own.middle)};
    if (!is_held) {
        const solver::RigidMotion of_part = fitted_motion_of(solved, own.part).motion;
        motion.translation = of_part.at(motion.center);
        motion.rotation = of_part.rotation;
    }
    Vec2 moved(0, 0), normal(0, 0);
    double turning = 0;
    for (const solver::InterfacePoint& p : own.face.points) {
        const Vec2 u = displacement_at(grid.input, solved.solution.displacement[own.part], p.element[side], own.place(p)).value;
        moved += p.weight / own.length * u;
        normal += p.weight * grid.frame.vector_to_global(p.normal[side]);
        turning += p.weight * cross(own.place(p) - own.middle, u);
    }
    const Vec2 beside = grid.frame.vector_to_global(moved) - motion.translation, across = normal.stableNormalized(),
               along = beside - beside.dot(across) * across;
    const double turned = turning / own.inertia - motion.rotation, pressed_in = indentation_of(solved, contact);
    const bool slides = along.norm() > pressed_in, turns = std::abs(turned) * own.length > pressed_in,
               goes_by_itself = (slides || turns) && !ends_at_mirror(solved, contact);
    motion.translation += slides && goes_by_itself ? beside : beside - along;
    if (turns && goes_by_itself) motion.rotation += turned;
    return motion;
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
