// SPDX-License-Identifier: GPL-3.0-or-later
// Was a file written meanwhile? Without reading it.
#pragma once
#include <cstdint>
#include <string>

namespace abut {

/// What the file system changes with every write. The time of the last change of the file's entry is among it, which no program
/// can set back: a file that is edited and restored is told, too. All zero where there is no file.
struct FileStamp {
    std::uint64_t device = 0, inode = 0, size = 0;
    std::int64_t written = 0, changed = 0;  ///< nanoseconds
    bool operator==(const FileStamp&) const = default;
};

/// The stamp of a file. Cost: one look-up, microseconds.
FileStamp file_stamp(const std::string& path);

/// Is the last change so short ago that another one may get the same time? Clocks of file systems go in steps.
bool is_recent(const FileStamp& stamp);

}  // namespace abut
