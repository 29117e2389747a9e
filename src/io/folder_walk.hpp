// SPDX-License-Identifier: GPL-3.0-or-later
// All files below a folder.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace abut {

struct FolderFiles {
    std::vector<std::filesystem::path> files;  ///< begin with the folder; in no order
    std::vector<std::string> left_out;         ///< folders that were not looked into against expectation, "in/link: why"
};

/// Files whose names do not begin with a dot, in the folder and the folders below. Links are followed: to files under the name
/// of the link, to folders where those are not looked into anyway and do not hold the link itself, so that each folder is
/// looked into once and cycles end. A folder that is reached in several ways is looked into where it is, else by the first link
/// in the order of their paths. Folders for which `passed_over` is true are left out without a word. Cost: one look-up a file.
/// Throws InputError where the folder itself cannot be read.
FolderFiles files_below(const std::string& folder, const std::function<bool(const std::filesystem::path&)>& passed_over);

}  // namespace abut
