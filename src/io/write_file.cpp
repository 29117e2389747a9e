// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/write_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "geometry/brep/input_error.hpp"
#include "src/io/temporary_file.hpp"

namespace abut {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
    throw InputError(file.string(), "cannot be written: " + reason, "choose another output folder, or free the place");
}

std::string last_error() {
    return errno != 0 ? std::strerror(errno) : "input/output error";
}

}  // namespace

void write_file(const std::string& directory, const std::string& name, const std::string& text) {
    const fs::path file = fs::path(directory) / name;
    std::error_code error;
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
    if (error) refuse(file, error.message());

    const fs::path temporary = file.parent_path() / temporary_name(file.filename().string());
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
    if (!stream) refuse(file, last_error());
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) {
        const std::string reason = last_error();
        fs::remove(temporary, error);
        refuse(file, reason);
    }
    fs::rename(temporary, file, error);  // within one folder: readers see the old file or the new one, never half of it
    if (error) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        refuse(file, error.message());
    }
}

}  // namespace abut
