// SPDX-License-Identifier: GPL-3.0-or-later
// Small meshes, and files of them, for tests.
#pragma once
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

#include "geometry/mesh/mesh_bodies.hpp"

namespace abut::geometry {

/// Prism over a counter-clockwise convex outline.
inline Mesh prism(const std::vector<Vec2>& outline, double bottom, double top, const std::string& name = "") {
    Mesh mesh{name, {}, {}};
    const int n = static_cast<int>(outline.size());
    for (double z : {bottom, top})
        for (const Vec2& p : outline) mesh.vertices.push_back({p.x(), p.y(), z});
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        mesh.triangles.push_back({i, j, n + j});
        mesh.triangles.push_back({i, n + j, n + i});
    }
    for (int i = 1; i + 1 < n; ++i) {
        mesh.triangles.push_back({0, i + 1, i});
        mesh.triangles.push_back({n, n + i, n + i + 1});
    }
    return mesh;
}

inline Mesh box(const Vec3& low, const Vec3& high, const std::string& name = "") {
    return prism({{low.x(), low.y()}, {high.x(), low.y()}, {high.x(), high.y()}, {low.x(), high.y()}}, low.z(), high.z(), name);
}

inline std::vector<Vec2> regular_polygon(const Vec2& center, double radius, int n, double start = 0) {
    std::vector<Vec2> points;
    for (int i = 0; i < n; ++i) {
        const double a = start + 2 * std::numbers::pi * i / n;
        points.push_back(center + radius * Vec2(std::cos(a), std::sin(a)));
    }
    return points;
}

inline void turn_inside_out(Mesh& mesh) {
    for (std::array<int, 3>& t : mesh.triangles) std::swap(t[1], t[2]);
}

/// Both in one soup, as formats without objects hold them.
inline Mesh together(const Mesh& a, const Mesh& b) {
    Mesh sum = a;
    const int shift = static_cast<int>(a.vertices.size());
    sum.vertices.insert(sum.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const std::array<int, 3>& t : b.triangles) sum.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    return sum;
}

/// As if a file had held these objects.
inline MeshFile bodies_of(const std::vector<Mesh>& objects) {
    MeshFile file;
    file.file = "test";
    MeshBodies bodies(file);
    for (const Mesh& object : objects) bodies.add(object);
    return bodies.finish();
}

inline std::string obj_text(const std::vector<Mesh>& meshes) {
    std::ostringstream text;
    text.precision(9);
    int shift = 1;
    for (const Mesh& mesh : meshes) {
        if (!mesh.name.empty()) text << "o " << mesh.name << "\n";
        for (const Vec3& v : mesh.vertices) text << "v " << v.x() << " " << v.y() << " " << v.z() << "\n";
        for (const auto& t : mesh.triangles) text << "f " << t[0] + shift << " " << t[1] + shift << " " << t[2] + shift << "\n";
        shift += static_cast<int>(mesh.vertices.size());
    }
    return text.str();
}

inline std::string ply_text(const Mesh& mesh) {
    std::ostringstream text;
    text.precision(9);
    text << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3& v : mesh.vertices) text << v.x() << " " << v.y() << " " << v.z() << "\n";
    for (const auto& t : mesh.triangles) text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
    return text.str();
}

inline std::string stl_text(const Mesh& mesh) {
    std::ostringstream text;
    text.precision(9);
    text << "solid " << mesh.name << "\n";
    for (const auto& t : mesh.triangles) {
        text << "facet normal 0 0 0\nouter loop\n";
        for (int i : t) {
            const Vec3& v = mesh.vertices[static_cast<std::size_t>(i)];
            text << "vertex " << v.x() << " " << v.y() << " " << v.z() << "\n";
        }
        text << "endloop\nendfacet\n";
    }
    text << "endsolid " << mesh.name << "\n";
    return text.str();
}

template <class T>
void append_bytes(std::string& to, T value) {
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

inline std::string stl_bytes(const Mesh& mesh) {
    std::string bytes(80, ' ');
    append_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
        bytes.append(12, '\0');
        for (int i : t)
            for (int k = 0; k < 3; ++k) append_bytes(bytes, static_cast<float>(mesh.vertices[static_cast<std::size_t>(i)][k]));
        bytes.append(2, '\0');
    }
    return bytes;
}

inline std::uint32_t crc32_of(const std::string& bytes) {
    std::uint32_t crc = ~0u;
    for (char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int k = 0; k < 8; ++k) crc = (crc >> 1) ^ ((crc & 1) ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

/// A zip file that holds the texts uncompressed.
inline std::string zip_bytes(const std::vector<std::pair<std::string, std::string>>& files) {
    std::string bytes, directory;
    for (const auto& [name, text] : files) {
        std::string fields;
        for (int v : {20, 0, 0, 0, 0x21}) append_bytes(fields, static_cast<std::uint16_t>(v));
        append_bytes(fields, crc32_of(text));
        append_bytes(fields, static_cast<std::uint32_t>(text.size()));
        append_bytes(fields, static_cast<std::uint32_t>(text.size()));
        append_bytes(fields, static_cast<std::uint16_t>(name.size()));
        append_bytes(fields, std::uint16_t{0});
        directory += "PK\1\2" + std::string("\24\0", 2) + fields + std::string(10, '\0');
        append_bytes(directory, static_cast<std::uint32_t>(bytes.size()));
        directory += name;
        bytes += "PK\3\4" + fields + name + text;
    }
    std::string end = "PK\5\6" + std::string(4, '\0');
    for (int k = 0; k < 2; ++k) append_bytes(end, static_cast<std::uint16_t>(files.size()));
    append_bytes(end, static_cast<std::uint32_t>(directory.size()));
    append_bytes(end, static_cast<std::uint32_t>(bytes.size()));
    return bytes + directory + end + std::string(2, '\0');
}

/// `resources` and `build` are the XML within those elements.
inline std::string three_mf_bytes(const std::string& unit, const std::string& resources, const std::string& build) {
    const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    return zip_bytes(
        {{"[Content_Types].xml",
          head + "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default Extension=\"rels\" "
                 "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"model\" "
                 "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
         {"_rels/.rels",
          head + "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
                 "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
                 "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
         {"3D/3dmodel.model", head + "<model unit=\"" + unit +
                                  "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">"
                                  "<resources>" +
                                  resources + "</resources><build>" + build + "</build></model>"}});
}

inline std::string three_mf_object(int id, const Mesh& mesh) {
    std::ostringstream text;
    text.precision(9);
    text << "<object id=\"" << id << "\" name=\"" << mesh.name << "\" type=\"model\"><mesh><vertices>";
    for (const Vec3& v : mesh.vertices) text << "<vertex x=\"" << v.x() << "\" y=\"" << v.y() << "\" z=\"" << v.z() << "\"/>";
    text << "</vertices><triangles>";
    for (const auto& t : mesh.triangles)
        text << "<triangle v1=\"" << t[0] << "\" v2=\"" << t[1] << "\" v3=\"" << t[2] << "\"/>";
    text << "</triangles></mesh></object>";
    return text.str();
}

/// A file that is there as long as this is, in a folder of its own: tests run side by side.
class TemporaryFile {
public:
    TemporaryFile(const std::string& name, const std::string& bytes) {
        std::string pattern = (std::filesystem::temp_directory_path() / "abut_file_XXXXXX").string();
        EXPECT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
        path_ = (folder_ / name).string();
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    ~TemporaryFile() { std::filesystem::remove_all(folder_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::string& path() const { return path_; }

private:
    std::filesystem::path folder_;
    std::string path_;
};

}  // namespace abut::geometry
