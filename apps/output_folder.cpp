// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/output_folder.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "geometry/brep/input_error.hpp"

namespace abut {

void prepare_output_folder(const std::string& folder) {
    const char* hint = "choose another folder with -o";
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw InputError(folder, "the output folder cannot be made: " + error.message(), hint);
    if (!std::filesystem::is_directory(folder, error)) throw InputError(folder, "the output folder is a file", hint);
    if (access(folder.c_str(), W_OK | X_OK) != 0) {
        throw InputError(folder, "the output folder cannot be written to: " + std::string(std::strerror(errno)), hint);
    }
}

std::string path_in(const std::string& folder, const std::string& name) {
    return (std::filesystem::path(folder) / name).lexically_normal().string();
}

}  // namespace abut
