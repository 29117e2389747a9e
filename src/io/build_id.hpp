// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace abut {

/// Which program this is: "0.1.0+1a2b3c4d5e6f", the version of the project in CMakeLists.txt and a hash of the sources that it
/// was built from. Two programs with the same text give the same answers.
std::string program_build();

}  // namespace abut
