// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/png_file.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "apps/output_folder.hpp"
#include "geometry/brep/input_error.hpp"

namespace abut {

bool can_write_png() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + png_program).c_str(), X_OK) == 0) return true;
    return false;
}

void write_png(const std::string& folder, const std::string& name, const std::string& svg) {
    std::string from = path_in(folder, svg), to = path_in(folder, name + ".png"), program = png_program, zoom = "--zoom=2",
                output = "--output";
    // A file name that begins with a hyphen is no option of that program.
    std::string marked = std::filesystem::absolute(from).string(), target = std::filesystem::absolute(to).string();
    char* words[] = {program.data(), zoom.data(), output.data(), target.data(), marked.data(), nullptr};
    pid_t child = 0;
    int status = 1;
    if (posix_spawnp(&child, png_program, nullptr, nullptr, words, environ) == 0) waitpid(child, &status, 0);
    if (status != 0) throw InputError(to, std::string("cannot be written by ") + png_program, "leave png out of the formats");
}

}  // namespace abut
