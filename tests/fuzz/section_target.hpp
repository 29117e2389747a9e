// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as the objects of a mesh file: bodies, their section, and the parts that it bounds.
#pragma once
#include <string>

#include "geometry/mesh/mesh_bodies.hpp"
#include "geometry/mesh/section.hpp"
#include "tests/fuzz/drawing_faults.hpp"
#include "tests/fuzz/mesh_bytes.hpp"

namespace abut::fuzz {

inline geometry::MeshFile mesh_file_of(SectionInput& input) {
    geometry::MeshFile file;
    file.file = "fuzzed.stl";
    file.format = "STL";
    if (!input.is_split) {
        file.bodies = std::move(input.objects);
        for (std::size_t i = 0; i < file.bodies.size(); ++i) file.bodies[i].name = "body" + std::to_string(i);
        return file;
    }
    geometry::MeshBodies bodies(std::move(file));
    for (Mesh& object : input.objects) bodies.add(std::move(object));
    return bodies.finish();
}

inline std::string fault_of_bodies(const geometry::MeshFile& file) {
    for (const auto& [kind, count] : file.counts)
        if (count.read != count.used + count.ignored) return "counts of the mesh do not add up: " + kind;
    for (const Mesh& body : file.bodies)
        if (body.name.empty() || body.triangles.empty()) return "a body without name or triangles";
    return "";
}

/// Empty where all is well; a refusal is well.
inline std::string fault_of_section(const std::string& bytes) {
    try {
        SectionInput input = section_input_of(bytes);
        const bool is_split = input.is_split;
        const geometry::MeshFile file = mesh_file_of(input);
        if (const std::string fault = is_split ? fault_of_bodies(file) : ""; !fault.empty()) return fault;
        const geometry::SectionPlane plane = input.plane.value_or(geometry::plane_of({}, file.bodies));
        const geometry::Drawing drawing = geometry::section(file, plane, input.tolerance);
        if (const std::string fault = fault_of_drawing(drawing); !fault.empty()) return fault;
        geometry::SketchOptions options;
        options.parts_by = geometry::PartsBy::layer;
        return fault_of_parts(geometry::parts_of(drawing, options));
    } catch (const InputError& error) { return fault_of_refusal(error); }
}

}  // namespace abut::fuzz
