// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

namespace abut {

/// All bytes of a file; nothing where it is missing, a folder or unreadable.
std::optional<std::string> whole_file(const std::string& path);

/// All bytes of a file; throws InputError where it is missing, a folder or unreadable.
std::string read_whole_file(const std::string& path);

/// The ending of a path in small letters, ".dxf"; empty where there is none.
std::string ending_of(const std::string& path);

}  // namespace abut
