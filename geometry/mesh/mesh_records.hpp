// SPDX-License-Identifier: GPL-3.0-or-later
// The objects of a mesh file on their way from the program that reads it (apps/readers/).
#pragma once
#include <string>

#include "geometry/foreign/record_stream.hpp"
#include "geometry/mesh/mesh_bodies.hpp"

namespace abut::geometry {

/// Writes what a file holds, in its order.
class MeshRecords {
public:
    explicit MeshRecords(RecordWriter& records) : records_(records) {}

    /// An object (or instance) as MeshBodies::add() takes it.
    void object(const Mesh& object);
    /// Something of the file that is no part of a body.
    void ignore(const std::string& what, const std::string& why);
    void unit(const std::string& unit);

private:
    RecordWriter& records_;
};

/// Reads all that was written into `bodies`. Throws InputError as RecordReader and MeshBodies::add() do.
void read_mesh_records(RecordReader& records, MeshBodies& bodies);

}  // namespace abut::geometry
