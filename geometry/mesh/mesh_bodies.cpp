// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_bodies.hpp"

#include <cmath>

#include "geometry/brep/input_error.hpp"
#include "geometry/brep/message_text.hpp"
#include "geometry/mesh/mesh_shells.hpp"
#include "geometry/mesh/mesh_weld.hpp"

namespace abut::geometry {

namespace {

Vec2 in_plan(const Vec3& p) {
    return {p.x(), p.y()};
}

std::string counted(int n, const std::string& one, const std::string& many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string place_in_space(const Vec3& p) {
    return "(" + number_text(p.x()) + ", " + number_text(p.y()) + ", " + number_text(p.z()) + ")";
}

/// What stands for an object in messages.
std::string called(const std::string& name) {
    return name.empty() ? "an object without a name" : name;
}

void report_weld(const Weld& done, const std::string& name, std::vector<Repair>& repairs) {
    const std::string in = " in " + called(name);
    if (done.n_joined > 0)
        repairs.push_back(
            {counted(done.n_joined, "vertex", "vertices") + " joined to a near one" + in, in_plan(done.at), done.moved});
    if (done.n_degenerate > 0)
        repairs.push_back({counted(done.n_degenerate, "triangle", "triangles") + " without area removed" + in,
                           in_plan(done.degenerate_at), 0});
    if (done.n_doubled > 0)
        repairs.push_back(
            {counted(done.n_doubled, "doubled triangle", "doubled triangles") + " removed" + in, in_plan(done.doubled_at), 0});
}

void report_shells(const Shells& done, const std::string& name, std::vector<Repair>& repairs) {
    const std::string in = " in " + called(name);
    if (done.n_turned > 0)
        repairs.push_back({counted(done.n_turned, "triangle", "triangles") + " turned to agree with the neighbours" + in,
                           in_plan(done.turned_at), 0});
    if (done.n_inverted > 0)
        repairs.push_back({counted(done.n_inverted, "shell that was", "shells that were") + " inside out turned" + in,
                           in_plan(done.inverted_at), 0});
    if (done.n_told_apart > 0)
        repairs.push_back({"bodies that touch along " + counted(done.n_told_apart, "edge", "edges") +
                               " told apart by the side of their material" + in,
                           in_plan(done.told_apart_at), 0});
}

void report_faults(const Shell& shell, const std::string& body, std::vector<SketchProblem>& problems) {
    if (shell.branching.n > 0)
        problems.push_back({"bodies share faces and cannot be told apart: " + counted(shell.branching.n, "edge", "edges") +
                                " where faces branch, the first at " + place_in_space(shell.branching.at),
                            in_plan(shell.branching.at), body, 0, "export the parts as separate objects"});
    if (shell.open.n > 0)
        problems.push_back({"the mesh has holes: " + counted(shell.open.n, "edge", "edges") +
                                " with a triangle on one side only, the first at " + place_in_space(shell.open.at) +
                                ", the longest of length " + number_text(shell.open.length),
                            in_plan(shell.open.at), body, 0, "export the part as a closed solid"});
}

/// Far from the origin single precision, in which formats hold coordinates and libraries read them, is coarse.
void report_coarseness(MeshFile& file) {
    Vec3 low = file.bodies.front().vertices.front(), high = low;
    for (const Mesh& body : file.bodies)
        for (const Vec3& v : body.vertices) {
            low = low.cwiseMin(v);
            high = high.cwiseMax(v);
        }
    const double largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
    const double step = std::ldexp(1.0, std::ilogb(largest) - 23);
    if (step <= told_coarseness * (high - low).norm()) return;
    file.repairs.push_back({"far from the origin coordinates are read in steps of " + number_text(step) +
                                " only (single precision): move the model to the origin before it is exported",
                            in_plan(low), 0.5 * step});
}

}  // namespace

void MeshBodies::check(const Mesh& object) const {
    const std::string name = called(object.name);
    if (n_triangles_ + object.triangles.size() > most_triangles)
        throw InputError(file_.file, "the file holds more than " + std::to_string(most_triangles) + " triangles",
                         "export it with a coarser mesh, or fewer parts");
    for (const Vec3& v : object.vertices) {
        if (!v.allFinite()) throw InputError(file_.file, "a vertex of " + name + " is not a number", "export the file again");
        if (v.cwiseAbs().maxCoeff() > largest_mesh_coordinate)
            throw InputError(file_.file, "a vertex of " + name + " is absurdly far away, at " + place_in_space(v),
                             "export the file again");
    }
    const int n = static_cast<int>(object.vertices.size());
    for (const std::array<int, 3>& t : object.triangles)
        for (int i : t)
            if (i < 0 || i >= n)
                throw InputError(file_.file, "a triangle of " + name + " names a vertex that is not there",
                                 "export the file again");
}

void MeshBodies::add_body(Mesh mesh, const std::string& base, bool is_one_of_several) {
    if (file_.bodies.size() >= most_bodies)
        throw InputError(file_.file, "the file holds more than " + std::to_string(most_bodies) + " bodies",
                         "export only the parts that matter");
    mesh.name = names_.next(base, is_one_of_several);
    ++file_.counts["body"].read;
    ++file_.counts["body"].used;
    file_.bodies.push_back(std::move(mesh));
}

void MeshBodies::add(Mesh object) {
    if (object.triangles.empty()) return;
    check(object);
    n_triangles_ += object.triangles.size();
    EntityCount& objects = file_.counts["object"];
    EntityCount& triangles = file_.counts["triangle"];
    const int n_read = static_cast<int>(object.triangles.size());
    ++objects.read;
    triangles.read += n_read;
    const Weld welded = weld(object);
    report_weld(welded, object.name, file_.repairs);
    triangles.ignored += welded.n_degenerate + welded.n_doubled;
    triangles.used += static_cast<int>(object.triangles.size());
    if (object.triangles.empty()) {
        ++objects.ignored;
        return ignore(called(object.name), 1, "none of its triangles has an area");
    }
    ++objects.used;
    Shells split = split_shells(object);
    report_shells(split, object.name, file_.repairs);
    for (Shell& shell : split.shells) {
        add_body(std::move(shell.mesh), object.name, split.shells.size() > 1);
        report_faults(shell, file_.bodies.back().name, file_.problems);
    }
}

void MeshBodies::ignore(const std::string& what, int count, const std::string& why) {
    for (Ignored& known : file_.ignored)
        if (known.what == what && known.why == why) {
            known.count += count;
            return;
        }
    file_.ignored.push_back({what, count, why});
}

MeshFile MeshBodies::finish() {
    if (file_.bodies.empty())
        throw InputError(file_.file, "the file holds no triangles", "export solids or surfaces as a mesh");
    report_coarseness(file_);
    return std::move(file_);
}

}  // namespace abut::geometry
