// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <filesystem>

#include "geometry/foreign/reader_process.hpp"

namespace abut::geometry {

std::string reader_path(const std::string& program) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    for (const fs::path& folder : {self.parent_path() / "../libexec/abut", fs::path(ABUT_READERS_FOLDER)}) {
        const fs::path path = (folder / program).lexically_normal();
        if (::access(path.c_str(), X_OK) == 0) return path.string();
    }
    return "";
}

}  // namespace abut::geometry
