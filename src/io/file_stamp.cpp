// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/file_stamp.hpp"

#include <sys/stat.h>

#include <ctime>

namespace abut {

namespace {

constexpr std::int64_t ns_per_second = 1000000000;
constexpr std::int64_t clock_step = 2 * ns_per_second;  // the coarsest in use: FAT, old network file systems

std::int64_t nanoseconds(const timespec& time) {
    return static_cast<std::int64_t>(time.tv_sec) * ns_per_second + time.tv_nsec;
}

}  // namespace

FileStamp file_stamp(const std::string& path) {
    struct stat entry {};
    if (::stat(path.c_str(), &entry) != 0) return {};
    return {entry.st_dev, entry.st_ino, static_cast<std::uint64_t>(entry.st_size), nanoseconds(entry.st_mtim),
            nanoseconds(entry.st_ctim)};
}

bool is_recent(const FileStamp& stamp) {
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    return stamp.changed > nanoseconds(now) - clock_step;
}

}  // namespace abut
