// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/foreign/readable_file.hpp"

#include <filesystem>
#include <fstream>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry {

std::uintmax_t checked_size(const std::string& path, std::uintmax_t most, const std::string& hint) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) throw InputError(path, "there is no such file");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || !std::ifstream(path)) throw InputError(path, "the file cannot be opened");
    if (size == 0) throw InputError(path, "the file is empty");
    if (size > most) throw InputError(path, "the file is larger than " + std::to_string(most >> 20) + " MB", hint);
    return size;
}

}  // namespace abut::geometry
