// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes out of bytes. Triangles at random hardly ever close, so half of the objects begin as prisms, which the bytes that
// follow then damage. Bytes that are missing count as 0.
//
//   mesh    = flags at objects...
//   flags   = one byte: 1 joined and split as a file's objects are (else each object is a body as it is), 2 the default plane,
//             4 a tolerance is given, 8 coordinates are doubles (else one byte, signed), next two bits: axis, next two: objects
//   object  = kind (even: prism, odd: free) name (a byte: none, a, b)
//   prism   = n height, n corners (x y), edits
//   free    = n_vertices n_triangles, vertices (x y z), triangles (three bytes), edits
//   edits   = n, n times: what, index, value
#pragma once
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/mesh/section.hpp"

namespace abut::fuzz {

using geometry::Mesh;
using geometry::Vec3;

inline constexpr int most_corners = 32, most_vertices = 48, most_triangles = 64, most_edits = 16;

class Bytes {
public:
    explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

    int byte() { return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : 0; }
    double coordinate(bool is_double) {
        if (!is_double) return static_cast<signed char>(byte());
        double value = 0;
        const std::size_t n = std::min(sizeof value, bytes_.size() - at_);
        std::memcpy(&value, bytes_.data() + at_, n);
        at_ += n;
        return value;
    }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

struct SectionInput {
    std::vector<Mesh> objects;
    bool is_split = false;  ///< objects are joined, mended and split into bodies, as those of files are
    std::optional<geometry::SectionPlane> plane;
    double tolerance = 0;
};

/// Bottom, top and sides of n corners, counter-clockwise as the corners are; caps are fans from the first corner.
inline void add_prism(Bytes& bytes, bool is_double, Mesh& mesh) {
    const int n = 3 + bytes.byte() % (most_corners - 2);
    const double height = bytes.coordinate(is_double);
    for (int i = 0; i < n; ++i) {
        const double x = bytes.coordinate(is_double), y = bytes.coordinate(is_double);
        mesh.vertices.push_back({x, y, 0});
        mesh.vertices.push_back({x, y, height});
    }
    for (int i = 0; i < n; ++i) {
        const int a = 2 * i, b = 2 * ((i + 1) % n);
        mesh.triangles.push_back({a, b, b + 1});
        mesh.triangles.push_back({a, b + 1, a + 1});
        if (i == 0 || i == n - 1) continue;
        mesh.triangles.push_back({0, b, a});
        mesh.triangles.push_back({1, a + 1, b + 1});
    }
}

inline void add_free(Bytes& bytes, bool is_double, Mesh& mesh) {
    const int n_vertices = bytes.byte() % most_vertices, n_triangles = bytes.byte() % most_triangles;
    for (int i = 0; i < n_vertices; ++i) {
        const double x = bytes.coordinate(is_double), y = bytes.coordinate(is_double), z = bytes.coordinate(is_double);
        mesh.vertices.push_back({x, y, z});
    }
    // One beyond the last now and then: such triangles are to be refused.
    for (int i = 0; i < n_triangles; ++i) {
        const int a = bytes.byte(), b = bytes.byte(), c = bytes.byte(), n = n_vertices + 1;
        mesh.triangles.push_back({a % n, b % n, c % n});
    }
}

inline void edit(Bytes& bytes, bool is_double, Mesh& mesh) {
    for (int n = bytes.byte() % most_edits; n > 0 && !mesh.vertices.empty() && !mesh.triangles.empty(); --n) {
        const int what = bytes.byte(), index = bytes.byte();
        const auto t = mesh.triangles.begin() + index % static_cast<int>(mesh.triangles.size());
        Vec3& v = mesh.vertices[static_cast<std::size_t>(index) % mesh.vertices.size()];
        switch (what % 5) {
            case 0:
                v[what / 5 % 3] = bytes.coordinate(is_double);
                break;
            case 1:
                std::swap((*t)[0], (*t)[1]);
                break;
            case 2:
                mesh.triangles.erase(t);
                break;
            case 3:
                mesh.triangles.push_back(*t);
                break;
            default:
                (*t)[static_cast<std::size_t>(what / 5 % 3)] = bytes.byte() % static_cast<int>(mesh.vertices.size());
        }
    }
}

inline Mesh object_of(Bytes& bytes, bool is_double) {
    constexpr const char* names[] = {"", "a", "b"};
    Mesh mesh;
    const bool is_free = bytes.byte() % 2 == 1;
    mesh.name = names[bytes.byte() % 3];
    is_free ? add_free(bytes, is_double, mesh) : add_prism(bytes, is_double, mesh);
    edit(bytes, is_double, mesh);
    return mesh;
}

inline SectionInput section_input_of(const std::string& text) {
    Bytes bytes(text);
    const int flags = bytes.byte();
    const bool is_double = (flags & 8) != 0;
    const double at = bytes.coordinate(is_double);
    SectionInput input;
    input.is_split = (flags & 1) != 0;
    if ((flags & 2) == 0) input.plane = geometry::SectionPlane{(flags >> 4) % 3, at};
    if ((flags & 4) != 0) input.tolerance = std::abs(at) / 100;
    for (int n = 1 + (flags >> 6); n > 0; --n) input.objects.push_back(object_of(bytes, is_double));
    return input;
}

}  // namespace abut::fuzz
