// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/late_library.hpp"

#include <gtest/gtest.h>

#include "geometry/input_error.hpp"

namespace abut::geometry {
namespace {

TEST(LateLibrary, GivesFunctionsByName) {
    const LateLibrary library("libm.so.6", "part.stl");
    EXPECT_EQ(library.function<double(double)>("floor")(2.5), 2);
}

TEST(LateLibrary, SaysWhatIsMissingAndWhatFor) {
    const auto message = [](auto act) -> std::string {
        try {
            act();
        } catch (const InputError& error) { return error.what(); }
        return "";
    };
    const std::string no_library = message([] { LateLibrary("libno_such_library.so.1", "part.stl"); });
    EXPECT_NE(no_library.find("part.stl"), std::string::npos) << no_library;
    EXPECT_NE(no_library.find("libno_such_library.so.1"), std::string::npos) << no_library;
    const std::string no_function = message([] { LateLibrary("libm.so.6", "part.stl").function<void()>("no_such_function"); });
    EXPECT_NE(no_function.find("no_such_function"), std::string::npos) << no_function;
}

}  // namespace
}  // namespace abut::geometry
