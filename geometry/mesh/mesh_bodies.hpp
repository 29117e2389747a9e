// SPDX-License-Identifier: GPL-3.0-or-later
// From the objects of a mesh file to its bodies, for the readers of formats and for those that hold no file.
#pragma once
#include <string>

#include "geometry/mesh/body_names.hpp"
#include "geometry/mesh/mesh.hpp"

namespace abut::geometry {

/// Steps of the coordinates that are more than this fraction of the diagonal of all bodies are told: they hide facets, and
/// gaps.
inline constexpr double told_coarseness = 1e-5;

/// Collects objects in the file's order.
class MeshBodies {
public:
    /// `file.file` names the file in messages.
    explicit MeshBodies(MeshFile file) : file_(std::move(file)) {}

    /// Adds one object (or instance), as the file states it, in the file's coordinates; an empty name: it has none. Joined,
    /// mended and split into bodies (mesh_weld.hpp, mesh_shells.hpp). Throws InputError for coordinates that are no numbers or
    /// beyond largest_mesh_coordinate, indices of vertices that are not there, and where a limit is passed.
    void add(Mesh object);
    /// Notes something of the file that is no part of a body.
    void ignore(const std::string& what, int count, const std::string& why);
    void set_unit(const std::string& unit) { file_.unit = unit; }
    /// The file with its bodies. Throws InputError if there are none.
    MeshFile finish();

private:
    void check(const Mesh& object) const;
    void add_body(Mesh mesh, const std::string& base, bool is_one_of_several);

    MeshFile file_;
    BodyNames names_{"shell"};
    std::size_t n_triangles_ = 0;
};

}  // namespace abut::geometry
