// SPDX-License-Identifier: GPL-3.0-or-later
// A folder of its own for the files that one test writes.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace abut {

class TemporaryFolder {
public:
    TemporaryFolder() {
        static int n_folders = 0;
        path_ = std::filesystem::temp_directory_path() /
                ("abut_test_" + std::to_string(getpid()) + "_" + std::to_string(n_folders++));
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path(const std::string& name) const { return (path_ / name).string(); }
    /// Writes a file and gives its path.
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path(name);
    }

private:
    std::filesystem::path path_;
};

}  // namespace abut
