// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/foreign/reader_main.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry {

namespace {

void limit(__rlimit_resource resource, rlim_t most) {
    rlimit bound{};
    ::getrlimit(resource, &bound);
    bound.rlim_cur = std::min({most, bound.rlim_cur, bound.rlim_max});
    ::setrlimit(resource, &bound);
}

void send(int output, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(output, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) ::_exit(1);  // nobody listens any more
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
}

/// Standard output for the records alone: what libraries print goes where standard error goes.
int take_output() {
    const int output = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    return output;
}

}  // namespace

void run_reader(int argc, char** argv, const ReadFile& read) {
    if (argc < 4) ::_exit(2);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, std::strtoull(argv[2], nullptr, 10));
    if (!is_sanitized) limit(RLIMIT_AS, std::strtoull(argv[1], nullptr, 10));  // shadow memory is larger than any limit
    std::set_new_handler([] { ::_exit(exit_no_memory); });
    const int output = take_output();
    RecordWriter records([output](std::string_view bytes) { send(output, bytes); });
    const auto fail = [&](const std::string& what, const std::string& hint) {
        records.kind(failure_record);
        records.text(what);
        records.text(hint);
    };
    records.kind(begin_record);
    try {
        read(argv[3], {argv + 4, argv + argc}, records);
        records.kind(end_record);
    } catch (const InputError& error) {
        fail(error.problems().front().what, error.problems().front().hint);
    } catch (const std::exception& error) { fail(error.what(), "export it again"); }
    records.flush();
    ::_exit(0);
}

}  // namespace abut::geometry
