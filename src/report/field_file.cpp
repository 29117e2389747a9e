// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/field_file.hpp"

#include <cstdint>
#include <cstring>

#include "src/io/base64.hpp"
#include "src/io/escape_xml.hpp"
#include "src/report/clipped_cells.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

constexpr int vtk_triangle = 5, vtk_quad = 9;  // [VTK file formats]

constexpr const char* vtk_head =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"%\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";
std::string head_of(const std::string& type) {
    std::string head = vtk_head;
    return head.replace(head.find('%'), 1, type);
}

/// Numbers behind the count of their bytes, as little-endian machines have them.
template <class Number>
std::string array_element(const std::string& type, const std::string& attributes, const std::vector<Number>& numbers) {
    const std::uint64_t n = numbers.size() * sizeof(Number);
    std::vector<std::uint8_t> bytes(sizeof n + n);
    std::memcpy(bytes.data(), &n, sizeof n);
    if (n > 0) std::memcpy(bytes.data() + sizeof n, numbers.data(), n);
    return "<DataArray type=\"" + type + "\" " + attributes + " format=\"binary\">" + base64(bytes) + "</DataArray>\n";
}

/// In XML's comments two hyphens end them.
std::string comment(std::string words) {
    for (std::size_t at = 0; (at = words.find("--")) != std::string::npos;) words.replace(at, 2, "- -");
    return "<!-- " + escape_xml(words) + " -->\n";
}

struct VtkMesh {
    std::vector<double> points, displacement, stress, von_mises;
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    std::vector<std::int32_t> part;

    void add(const report::ClippedCells& mesh, std::int32_t of_part) {
        const auto base = static_cast<std::int64_t>(points.size() / 3);
        for (const FieldSample& s : mesh.points) {
            points.insert(points.end(), {s.at.x(), s.at.y(), 0});
            displacement.insert(displacement.end(), {s.displacement.x(), s.displacement.y(), 0});
            stress.insert(stress.end(), {s.stress.xx, s.stress.yy, s.stress.zz, s.stress.xy, 0, 0});
            von_mises.push_back(abut::von_mises(s.stress));
        }
        for (const std::vector<int>& cell : mesh.cells) {
            for (int k : cell) connectivity.push_back(base + k);
            offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
            types.push_back(cell.size() == 3 ? vtk_triangle : vtk_quad);
            part.push_back(of_part);
        }
    }
};

}  // namespace

std::string fields_vtu(const Result& result) {
    VtkMesh mesh;
    const ResultUnits units = result_units(result);
    std::string notes =
        comment(result.title + "; length: " + units.length + ", force: " + units.force + ", stress: " + units.stress);
    for (std::size_t i = 0; i < result.fields.size() && i < result.geometry.size(); ++i) {
        if (result.fields[i].patches.empty()) continue;
        mesh.add(report::clipped_cells(result.fields[i], result.geometry[i]), static_cast<std::int32_t>(i + 1));
        notes += comment("part " + std::to_string(i + 1) + ": " + result.parts[i].name);
    }
    std::string text = head_of("UnstructuredGrid") + notes + "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
                       std::to_string(mesh.points.size() / 3) + "\" NumberOfCells=\"" + std::to_string(mesh.offsets.size()) +
                       "\">\n<Points>\n";
    text += array_element("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", mesh.points) + "</Points>\n<Cells>\n";
    text += array_element("Int64", "Name=\"connectivity\"", mesh.connectivity);
    text += array_element("Int64", "Name=\"offsets\"", mesh.offsets);
    text += array_element("UInt8", "Name=\"types\"", mesh.types) + "</Cells>\n";
    text += "<PointData Scalars=\"von Mises stress\" Vectors=\"displacement\">\n";
    text += array_element("Float64", "Name=\"displacement\" NumberOfComponents=\"3\"", mesh.displacement);
    text += array_element("Float64",
                          "Name=\"stress\" NumberOfComponents=\"6\" ComponentName0=\"XX\" ComponentName1=\"YY\" "
                          "ComponentName2=\"ZZ\" ComponentName3=\"XY\" ComponentName4=\"YZ\" ComponentName5=\"XZ\"",
                          mesh.stress);
    text +=
        array_element("Float64", "Name=\"von Mises stress\"", mesh.von_mises) + "</PointData>\n<CellData Scalars=\"part\">\n";
    text += array_element("Int32", "Name=\"part\"", mesh.part);
    return text + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string fields_pvd(const std::vector<std::pair<std::string, std::string>>& names_and_files) {
    std::string text = head_of("Collection") + "<Collection>\n";
    int time = 0;
    for (const auto& [name, file] : names_and_files)
        text += "<DataSet timestep=\"" + std::to_string(++time) + "\" group=\"\" part=\"0\" name=\"" + escape_xml(name) +
                "\" file=\"" + escape_xml(file) + "\"/>\n";
    return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace abut
