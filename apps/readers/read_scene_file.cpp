// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/readers/read_scene_file.hpp"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <string_view>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry {

namespace {

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

/// Objects out of the tree of nodes. The meshes of one node are one object: they differ in material only.
class SceneReader {
public:
    SceneReader(const aiScene& scene, std::string format, MeshRecords& records)
        : scene_(scene), format_(std::move(format)), records_(records) {}

    void read(const aiNode& node, const Eigen::Affine3d& above) {
        const Eigen::Affine3d placement = above * placement_of(node.mTransformation);
        if (node.mNumMeshes > 0) records_.object(object_of(node, placement));
        for (unsigned k = 0; k < node.mNumChildren; ++k) read(*node.mChildren[k], placement);
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
        const unsigned shift = static_cast<unsigned>(object.vertices.size());
        const bool mirrors = placement.linear().determinant() < 0;
        for (unsigned k = 0; k < mesh.mNumVertices; ++k) {
            const aiVector3D& v = mesh.mVertices[k];
            object.vertices.push_back(placement *
                                      Vec3(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)));
        }
        for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
            const aiFace& face = mesh.mFaces[k];
            if (face.mNumIndices != 3) {
                records_.ignore(face.mNumIndices == 1 ? "point" : face.mNumIndices == 2 ? "line" : "polygon", "bounds no body");
                continue;
            }
            const auto at = [&](unsigned i) { return static_cast<int>(face.mIndices[i] + shift); };
            object.triangles.push_back(mirrors ? std::array<int, 3>{at(0), at(2), at(1)}
                                               : std::array<int, 3>{at(0), at(1), at(2)});
        }
    }

    const aiScene& scene_;
    std::string format_;
    MeshRecords& records_;
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

/// Never released: the process ends with it. Null where assimp cannot read the file.
const aiScene* scene_of(const std::string& path, const std::string& format) {
    aiPropertyStore* properties = aiCreatePropertyStore();
    for (const char* name : {AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION,  // the file's own coordinates
                             AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES})   // not the identifiers
        aiSetImportPropertyInteger(properties, name, 1);
    if (format != "OBJ") return aiImportFileExWithProperties(path.c_str(), aiProcess_Triangulate, nullptr, properties);
    const std::string text = obj_with_whole_names(path);
    return aiImportFileFromMemoryWithProperties(text.data(), static_cast<unsigned>(text.size()), aiProcess_Triangulate, "obj",
                                                properties);
}

}  // namespace

void read_scene_file(const std::string& path, const std::string& format, MeshRecords& records) {
    const aiScene* scene = scene_of(path, format);
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw InputError(path, "the file is no " + format + ", or damaged" + first_line(aiGetErrorString()), "export it again");
    SceneReader(*scene, format, records).read(*scene->mRootNode, Eigen::Affine3d::Identity());
}

}  // namespace abut::geometry
