// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/temporary_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "tests/src/io/temporary_folder.hpp"

namespace abut::temporary_file_test {

TEST(TemporaryFile, OfDeadProcessesAreRemovedAndNoOthers) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    const auto of = [](const std::string& host, pid_t process) {
        return ".index.html." + host + "-" + std::to_string(process) + ".tmp";
    };
    EXPECT_EQ(temporary_name("index.html"), of(host_name(), ::getpid()));
    const TemporaryFolder folder;
    const std::string dead = folder.write(of(host_name(), child), "half");
    const std::string own = folder.write(temporary_name("index.html"), "half"),
                      elsewhere = folder.write(of("another" + host_name(), child), "half"),
                      whole = folder.write("index.html", "whole"), hidden = folder.write(".tmp", "");
    remove_abandoned(std::filesystem::path(dead).parent_path());
    EXPECT_FALSE(std::filesystem::exists(dead));
    for (const std::string& kept : {own, elsewhere, whole, hidden}) EXPECT_TRUE(std::filesystem::exists(kept)) << kept;
}

}  // namespace abut::temporary_file_test
