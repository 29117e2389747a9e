// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace abut {

/// The version of the project in CMakeLists.txt; a test holds the two together.
inline constexpr const char* program_version = "0.1.0";

}  // namespace abut
