// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/temporary_file.hpp"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill() is of POSIX
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <system_error>

namespace abut {

namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".tmp";

std::string mark_of_host() {
    return "." + host_name() + "-";
}

/// 0: the name is none of this host's.
pid_t process_of(const std::string& name) {
    const std::string mark = mark_of_host();
    const std::size_t at = name.rfind(mark);
    if (!name.starts_with('.') || !name.ends_with(ending) || at == std::string::npos) return 0;
    pid_t process = 0;
    const char *begin = name.data() + at + mark.size(), *end = name.data() + name.find(ending, at + mark.size());
    const auto [last, error] = std::from_chars(begin, end, process);
    return error == std::errc() && last == end && process > 0 ? process : 0;
}

}  // namespace

std::string host_name() {
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0) return "host";
    return name.data();
}

std::string temporary_name(const std::string& file) {
    return "." + file + mark_of_host() + std::to_string(::getpid()) + ending;
}

void remove_abandoned(const std::string& folder) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        const pid_t process = process_of(entry.path().filename().string());
        std::error_code ignored;
        if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) fs::remove(entry.path(), ignored);
    }
}

}  // namespace abut
