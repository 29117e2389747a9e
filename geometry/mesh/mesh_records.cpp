// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_records.hpp"

namespace abut::geometry {

namespace {

constexpr char object_record = 'o', ignored_record = 'i', unit_record = 'u';
/// Every triangle with vertices of its own, and one that is told to be too many.
constexpr std::size_t most_record_vertices = 3 * (most_triangles + 1);

static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(std::array<int, 3>) == 3 * sizeof(int));

Mesh read_object(RecordReader& records) {
    Mesh object;
    object.name = records.text();
    object.vertices.resize(records.count(most_record_vertices));
    if (!object.vertices.empty()) records.numbers(object.vertices.front().data(), 3 * object.vertices.size());
    object.triangles.resize(records.count(most_triangles + 1));
    if (!object.triangles.empty()) records.indices(object.triangles.front().data(), 3 * object.triangles.size());
    return object;
}

}  // namespace

void MeshRecords::object(const Mesh& object) {
    records_.kind(object_record);
    records_.text(object.name);
    // What is beyond the limit is not needed to say that there is too much.
    const std::size_t n_vertices = std::min(object.vertices.size(), most_record_vertices);
    const std::size_t n_triangles = std::min(object.triangles.size(), most_triangles + 1);
    records_.count(n_vertices);
    if (n_vertices > 0) records_.numbers(object.vertices.front().data(), 3 * n_vertices);
    records_.count(n_triangles);
    if (n_triangles > 0) records_.indices(object.triangles.front().data(), 3 * n_triangles);
}

void MeshRecords::ignore(const std::string& what, const std::string& why) {
    records_.kind(ignored_record);
    records_.text(what);
    records_.text(why);
}

void MeshRecords::unit(const std::string& unit) {
    records_.kind(unit_record);
    records_.text(unit);
}

void read_mesh_records(RecordReader& records, MeshBodies& bodies) {
    if (records.kind() != begin_record) records.refuse();
    for (char kind = records.kind(); kind != end_record; kind = records.kind()) {
        if (kind == object_record) {
            bodies.add(read_object(records));
        } else if (kind == ignored_record) {
            const std::string what = records.text(), why = records.text();
            bodies.ignore(what, 1, why);
        } else if (kind == unit_record) {
            bodies.set_unit(records.text());
        } else {
            records.refuse();
        }
    }
}

}  // namespace abut::geometry
