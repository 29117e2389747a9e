// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh_prechecks.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "geometry/input_error.hpp"

namespace abut::geometry {

namespace {

std::uintmax_t checked_size(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) throw InputError(path, "there is no such file");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || !std::ifstream(path)) throw InputError(path, "the file cannot be opened");
    if (size == 0) throw InputError(path, "the file is empty");
    if (size > most_mesh_bytes)
        throw InputError(path, "the file is larger than " + std::to_string(most_mesh_bytes >> 20) + " MB",
                         "export it with a coarser mesh, or fewer parts");
    return size;
}

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

/// Lines that hold anything.
std::uintmax_t count_lines(std::istream& in) {
    std::uintmax_t n = 0;
    bool is_blank = true;
    for (std::istreambuf_iterator<char> c(in), end; c != end; ++c) {
        if (*c == '\n' || *c == '\r') {
            n += is_blank ? 0 : 1;
            is_blank = true;
        } else if (!std::isspace(static_cast<unsigned char>(*c))) {
            is_blank = false;
        }
    }
    return n + (is_blank ? 0 : 1);
}

/// assimp reads for ever where the header does not end, and for as long as the header says.
void check_ply(const std::string& path, std::uintmax_t size) {
    std::ifstream in(path, std::ios::binary);
    std::string line;
    std::uintmax_t n_elements = 0;
    bool is_text = false, ends = false;
    std::getline(in, line);
    if (line.rfind("ply", 0) != 0 && line.rfind("PLY", 0) != 0)
        throw InputError(path, "the file is no PLY, or damaged", "export it again");
    while (!ends && std::getline(in, line)) {
        std::istringstream words(line);
        std::string word, what;
        words >> word;
        ends = word == "end_header";
        if (word == "format") {
            words >> what;
            is_text = what == "ascii";
        }
        if (word != "element") continue;
        std::uintmax_t n = 0;
        if (!(words >> what >> n) || n > size)
            throw InputError(path, "the PLY file is damaged: '" + line + "'", "export it again");
        n_elements += n;
    }
    if (!ends) throw InputError(path, "the PLY file is damaged: its header does not end", "export it again");
    const std::uintmax_t n_held = is_text ? count_lines(in) : size - static_cast<std::uintmax_t>(in.tellg());
    if (n_held < n_elements)
        throw InputError(path, "the PLY file is truncated: it states " + std::to_string(n_elements) + " elements",
                         "export it again");
}

}  // namespace

void check_mesh_file(const std::string& path, const std::string& format) {
    const std::uintmax_t size = checked_size(path);
    if (format == "STL") check_stl(path, size);
    if (format == "PLY") check_ply(path, size);
}

}  // namespace abut::geometry
