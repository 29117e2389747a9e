// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

/// The script tests/launcher_test.sh says what has failed.
TEST(Launcher, ItsScriptedTestsPass) {
    const std::string command = "bash '" ABUT_SOURCE_DIR "/tests/launcher_test.sh' </dev/null";
    const int code = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(code));
    EXPECT_EQ(WEXITSTATUS(code), 0);
}
