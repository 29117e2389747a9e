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

bool has_folder(const fs::path& folder, const char* inside) {
    std::error_code error;
    return fs::is_directory(folder / inside, error);
}

/// The folder data/ that came with the program, where it holds a certain folder.
std::string data_with(const char* inside, const std::string& command, const std::string& hint) {
    const std::vector<fs::path> places{program_file().parent_path() / "../share/abut", fs::path(ABUT_SOURCE_FOLDER) / "data"};
    for (const fs::path& folder : places)
        if (has_folder(folder, inside)) return folder.lexically_normal().string();
    throw InputError(command,
                     "the folder '" + std::string(inside) + "' that it needs is not found, neither in " +
                         places[0].lexically_normal().string() + " nor in " + places[1].string(),
                     hint);
}

}  // namespace

std::string data_folder(const Arguments& arguments) {
    if (has(arguments, "--data")) {
        const std::string folder = arguments.options.at("--data");
        if (has_folder(folder, "verification")) return folder;
        throw InputError("--data", "there is no folder 'verification' in " + folder, "give the folder data/ of abut's sources");
    }
    return data_with("verification", "verify", "give the folder above it by --data DIR");
}

std::string schema_folder() {
    return data_with("schema", "help", "install abut again, or build it from its sources") + "/schema";
}

}  // namespace abut
