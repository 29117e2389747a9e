// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/late_library.hpp"

#include <gtest/gtest.h>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry::late_library_test {
namespace {

TEST(LateLibrary, GivesFunctionsByName) {
    const LateLibrary library("libm.so.6", "");
    EXPECT_EQ(library.function<double(double)>("floor", "part.stl")(2.5), 2);
    EXPECT_EQ(LateLibrary("libno_such_library.so.1", "libm.so.6").function<double(double)>("floor", "part.stl")(2.5), 2);
}

TEST(LateLibrary, SaysWhatIsMissingAndWhatFor) {
    const auto message = [](auto act) -> std::string {
        try {
            act();
        } catch (const InputError& error) { return error.what(); }
        return "";
    };
    const std::string no_library = message([] { LateLibrary("libno.so.1", "/libno.so").function<void()>("f", "part.stl"); });
    EXPECT_NE(no_library.find("part.stl"), std::string::npos) << no_library;
    EXPECT_NE(no_library.find("libno.so.1"), std::string::npos) << no_library;
    const std::string no_function = message([] { LateLibrary("libm.so.6", "").function<void()>("no_such_function", "a.stl"); });
    EXPECT_NE(no_function.find("no_such_function"), std::string::npos) << no_function;
    EXPECT_NE(no_function.find("a.stl"), std::string::npos) << no_function;
}

}  // namespace
}  // namespace abut::geometry::late_library_test
