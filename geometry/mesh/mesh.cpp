// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh.hpp"

#include <cctype>
#include <filesystem>
#include <map>

#include "geometry/brep/input_error.hpp"
#include "geometry/foreign/reader_process.hpp"
#include "geometry/mesh/mesh_bodies.hpp"
#include "geometry/mesh/mesh_prechecks.hpp"
#include "geometry/mesh/mesh_records.hpp"

namespace abut::geometry {

namespace {

const std::map<std::string, std::string> formats = {{".stl", "STL"},  {".obj", "OBJ"},     {".ply", "PLY"}, {".gltf", "glTF"},
                                                    {".glb", "glTF"}, {".dae", "COLLADA"}, {".3mf", "3MF"}};

/// Empty if it is none of ours.
std::string format_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto found = formats.find(extension);
    return found == formats.end() ? "" : found->second;
}

ForeignReader mesh_reader(const std::string& library, const std::string& hint) {
    // Files of most_triangles took up to 410 MB of memory, text in addition its size, and 1.7 s (3MF, 10 MB) on a slow machine:
    // five times as much is allowed, and some seconds for a start.
    return {"abut-read-mesh", library, hint, "install abut again, or build it from its sources", 2ull << 30, 4, 5, 0.5};
}

ForeignReader reader_of(const std::string& format) {
    return format == "3MF" ? mesh_reader("lib3mf", "export it again, or as STL")
                           : mesh_reader("assimp", "export it again, or as 3MF");
}

}  // namespace

bool is_mesh_file(const std::string& path) {
    return !format_of(path).empty();
}

MeshFile read_mesh_file(const std::string& path) {
    const std::string format = format_of(path);
    if (format.empty()) throw InputError(path, "files of this kind are no meshes", "give STL, OBJ, PLY, glTF, COLLADA or 3MF");
    check_mesh_file(path, format);
    MeshFile file;
    file.file = path;
    file.format = format;
    if (format == "glTF" || format == "COLLADA") file.unit = "m";
    MeshBodies bodies(std::move(file));
    ReaderProcess reader(reader_of(format), path, {format});
    read_mesh_records(reader.records(), bodies);
    return bodies.finish();
}

}  // namespace abut::geometry
