// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/data_folder.hpp"

#include <filesystem>
#include <system_error>
#include <vector>

#include "geometry/brep/input_error.hpp"

namespace abut {

namespace {

namespace fs = std::filesystem;

/// The program's own file; empty where the system does not tell.
fs::path program_file() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error);
}

bool has_verification(const fs::path& folder) {
    std::error_code error;
    return fs::is_directory(folder / "verification", error);
}

}  // namespace

std::string data_folder(const Arguments& arguments) {
    if (has(arguments, "--data")) {
        const std::string folder = arguments.options.at("--data");
        if (has_verification(folder)) return folder;
        throw InputError("--data", "there is no folder 'verification' in " + folder, "give the folder data/ of abut's sources");
    }
    const std::vector<fs::path> places{program_file().parent_path() / "../share/abut", fs::path(ABUT_SOURCE_FOLDER) / "data"};
    for (const fs::path& folder : places)
        if (has_verification(folder)) return folder.lexically_normal().string();
    throw InputError(
        "verify",
        "its scenes are not found, neither in " + places[0].lexically_normal().string() + " nor in " + places[1].string(),
        "give their folder by --data DIR");
}

}  // namespace abut
