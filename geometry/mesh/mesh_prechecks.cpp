// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_prechecks.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>

#include "geometry/brep/input_error.hpp"
#include "geometry/foreign/readable_file.hpp"

namespace abut::geometry {

namespace {

/// A binary STL that was cut off would be taken for text, and fail there with a message that misleads. Text begins with
/// "solid"; so do some binary files, which hold zeros soon.
void check_stl(const std::string& path, std::uintmax_t size) {
    std::ifstream in(path, std::ios::binary);
    char head[84] = {};
    in.read(head, sizeof head);
    const char* end = head + in.gcount();
    const bool is_whole_head = end == head + sizeof head;
    std::uint32_t n = 0;
    std::memcpy(&n, head + 80, sizeof n);
    const std::uintmax_t stated = 84 + 50 * static_cast<std::uintmax_t>(n);
    if (is_whole_head && stated == size) return;
    const char* text =
        std::find_if(static_cast<const char*>(head), end, [](char c) { return !std::isspace(static_cast<unsigned char>(c)); });
    const bool is_text = end - text >= 5 && std::strncmp(text, "solid", 5) == 0 && std::find(text, end, '\0') == end;
    if (!is_text && (!is_whole_head || stated > size))
        throw InputError(path, "the STL file is truncated, or no STL", "export it again");
}

/// Formats that assimp tells by what they hold, whatever their name.
void check_beginning(const std::string& path, const std::string& format) {
    std::ifstream in(path, std::ios::binary);
    std::string head(1024, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    if (head.rfind("\xEF\xBB\xBF", 0) == 0) head.erase(0, 3);
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    const std::string begins = format == "glTF" ? "{" : "<";
    if (first != std::string::npos && head.compare(first, 1, begins) == 0) return;
    if (format == "glTF" && head.rfind("glTF", 0) == 0) return;
    throw InputError(path, "the file is no " + format + ", or damaged", "export it again");
}

}  // namespace

void check_mesh_file(const std::string& path, const std::string& format) {
    const std::uintmax_t size = checked_size(path, most_mesh_bytes, "export it with a coarser mesh, or fewer parts");
    if (format == "STL") check_stl(path, size);
    if (format == "glTF" || format == "COLLADA") check_beginning(path, format);
}

}  // namespace abut::geometry
