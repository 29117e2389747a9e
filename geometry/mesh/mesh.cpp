// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh.hpp"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <string_view>

#include "geometry/brep/input_error.hpp"
#include "geometry/mesh/late_library.hpp"
#include "geometry/mesh/mesh_3mf.hpp"
#include "geometry/mesh/mesh_bodies.hpp"
#include "geometry/mesh/mesh_prechecks.hpp"

namespace abut::geometry {

namespace {

/// Nodes within nodes deeper than this are damage.
constexpr int deepest_nodes = 256;

const std::map<std::string, std::string> formats = {{".stl", "STL"},  {".obj", "OBJ"},     {".ply", "PLY"}, {".gltf", "glTF"},
                                                    {".glb", "glTF"}, {".dae", "COLLADA"}, {".3mf", "3MF"}};

/// Empty if it is none of ours.
std::string format_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto found = formats.find(extension);
    return found == formats.end() ? "" : found->second;
}

/// Exporters' fillings for names that nobody gave.
std::string given_name(const aiString& assimp_name, const std::string& format) {
    std::string name(assimp_name.C_Str());
    std::replace_if(
        name.begin(), name.end(), [](char c) { return std::iscntrl(static_cast<unsigned char>(c)); }, ' ');
    const std::size_t first = name.find_first_not_of(' '), last = name.find_last_not_of(' ');
    name = first == std::string::npos ? "" : name.substr(first, last - first + 1);
    const bool is_made_up = name.empty() || name[0] == '<' || name[0] == '$' || name.rfind("nodes[", 0) == 0 ||
                            name.rfind("meshes[", 0) == 0 || name == "ROOT" || name == "defaultobject" ||
                            (format == "STL" && (name == "ASCII" || name == "AssimpScene"));
    return is_made_up ? "" : name;
}

Eigen::Affine3d placement_of(const aiMatrix4x4& m) {
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    for (unsigned row = 0; row < 3; ++row)
        for (unsigned column = 0; column < 4; ++column)
            map(static_cast<int>(row), static_cast<int>(column)) = static_cast<double>(m[row][column]);
    return map;
}

/// Bodies out of the tree of nodes. The meshes of one node are one object: they differ in material only.
class SceneReader {
public:
    SceneReader(const aiScene& scene, std::string file, std::string format, MeshBodies& bodies)
        : scene_(scene), file_(std::move(file)), format_(std::move(format)), bodies_(bodies) {}

    void read(const aiNode& node, const Eigen::Affine3d& above, int depth) {
        if (depth > deepest_nodes) throw InputError(file_, "objects are nested too deeply", "export the file again");
        const Eigen::Affine3d placement = above * placement_of(node.mTransformation);
        if (node.mNumMeshes > 0) bodies_.add(object_of(node, placement));
        for (unsigned k = 0; k < node.mNumChildren; ++k) read(*node.mChildren[k], placement, depth + 1);
    }

private:
    Mesh object_of(const aiNode& node, const Eigen::Affine3d& placement) {
        Mesh object;
        object.name = given_name(node.mName, format_);
        for (unsigned k = 0; k < node.mNumMeshes; ++k) {
            const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[k]];
            if (object.name.empty()) object.name = given_name(mesh.mName, format_);
            append(mesh, placement, object);
        }
        return object;
    }

    void append(const aiMesh& mesh, const Eigen::Affine3d& placement, Mesh& object) {
        n_triangles_ += mesh.mNumFaces;
        if (n_triangles_ > most_triangles)
            throw InputError(file_, "the file holds more than " + std::to_string(most_triangles) + " triangles",
                             "export it with a coarser mesh, or fewer parts");
        const int shift = static_cast<int>(object.vertices.size());
        const bool mirrors = placement.linear().determinant() < 0;
        for (unsigned k = 0; k < mesh.mNumVertices; ++k) {
            const aiVector3D& v = mesh.mVertices[k];
            object.vertices.push_back(placement *
                                      Vec3(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)));
        }
        for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
            const aiFace& face = mesh.mFaces[k];
            if (face.mNumIndices != 3) {
                bodies_.ignore(face.mNumIndices == 1   ? "point"
                               : face.mNumIndices == 2 ? "line"
                                                       : "polygon",
                               1, "bounds no body");
                continue;
            }
            const auto at = [&](unsigned i) { return static_cast<int>(face.mIndices[i]) + shift; };
            object.triangles.push_back(mirrors ? std::array<int, 3>{at(0), at(2), at(1)}
                                               : std::array<int, 3>{at(0), at(1), at(2)});
        }
    }

    const aiScene& scene_;
    std::string file_, format_;
    MeshBodies& bodies_;
    std::size_t n_triangles_ = 0;
};

/// assimp's messages run over several lines, or are empty.
std::string first_line(const std::string& message) {
    const std::string line = message.substr(0, message.find('\n'));
    return line.empty() ? "" : " (" + line + ")";
}

/// assimp ends names in OBJ at the first space, so that "left jaw" and "left pad" become one object: spaces within names of
/// objects and groups become control characters, which given_name() turns back.
std::string obj_with_whole_names(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        const std::string_view line(text.data() + begin, end - begin);
        const std::size_t name = line.find_first_not_of(" \t", 1), last = line.find_last_not_of(" \t");
        if ((line.rfind("o ", 0) == 0 || line.rfind("g ", 0) == 0) && name != std::string_view::npos && name < last)
            std::replace(text.begin() + static_cast<std::ptrdiff_t>(begin + name),
                         text.begin() + static_cast<std::ptrdiff_t>(begin + last), ' ', '\x1f');
        begin = end + 1;
    }
    return text;
}

/// Released when it goes; empty, and why, where assimp cannot read the file.
std::shared_ptr<const aiScene> read_by_assimp(const std::string& path, const std::string& format, std::string& message) {
    static const LateLibrary library(ABUT_ASSIMP, ABUT_ASSIMP_PATH);
    const std::shared_ptr<aiPropertyStore> properties(ABUT_LATE(library, aiCreatePropertyStore, path)(),
                                                      ABUT_LATE(library, aiReleasePropertyStore, path));
    for (const char* name : {AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION,  // the file's own coordinates
                             AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES})   // not the identifiers
        ABUT_LATE(library, aiSetImportPropertyInteger, path)(properties.get(), name, 1);
    const auto from_file = ABUT_LATE(library, aiImportFileExWithProperties, path);
    const auto from_memory = ABUT_LATE(library, aiImportFileFromMemoryWithProperties, path);
    const auto last_error = ABUT_LATE(library, aiGetErrorString, path);
    const aiScene* scene = nullptr;
    try {
        if (format == "OBJ") {
            const std::string text = obj_with_whole_names(path);
            if (text.size() > std::numeric_limits<unsigned>::max())
                throw InputError(path, "the file is larger than 4 GiB", "export fewer parts, or as STL");
            scene =
                from_memory(text.data(), static_cast<unsigned>(text.size()), aiProcess_Triangulate, "obj", properties.get());
        } else {
            scene = from_file(path.c_str(), aiProcess_Triangulate, nullptr, properties.get());
        }
        if (scene == nullptr) message = last_error();
    } catch (const InputError&) { throw; } catch (const std::exception& error) {
        message = error.what();
    }
    return {scene, ABUT_LATE(library, aiReleaseImport, path)};
}

void read_scene(const std::string& path, const std::string& format, MeshBodies& bodies) {
    std::string message;
    const std::shared_ptr<const aiScene> scene = read_by_assimp(path, format, message);
    if (!scene || !scene->mRootNode)
        throw InputError(path, "the file is no " + format + ", or damaged" + first_line(message), "export it again");
    SceneReader(*scene, path, format, bodies).read(*scene->mRootNode, Eigen::Affine3d::Identity(), 0);
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
    if (format == "3MF")
        read_3mf(path, bodies);
    else
        read_scene(path, format, bodies);
    return bodies.finish();
}

}  // namespace abut::geometry
