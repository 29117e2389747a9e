// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/child_text.hpp"

#include <unistd.h>

#include <cerrno>
#include <exception>
#include <new>
#include <string_view>

namespace abut::child {

namespace {

void send(int pipe, std::string_view text) {
    while (!text.empty()) {
        const ssize_t n = ::write(pipe, text.data(), text.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return;  // the parent sees that something is missing
        text.remove_prefix(static_cast<std::size_t>(n));
    }
}

}  // namespace

// Handlers ask for no memory: there may be none, and nothing thrown here may reach the parent's code in the child.
void work_and_end(const std::function<std::string()>& work, int pipe) noexcept {
    constexpr std::string_view first_done(&done, 1), first_thrown(&thrown, 1);
    try {
        const std::string text = work();
        send(pipe, first_done);
        send(pipe, text);
        send(pipe, first_done);
    } catch (const std::bad_alloc&) {
        send(pipe, first_thrown);
        send(pipe, "there is not enough memory");
    } catch (const std::exception& error) {
        send(pipe, first_thrown);
        send(pipe, error.what());
    }
    ::_exit(0);  // no destructors, no flushing: all that is the parent's
}

}  // namespace abut::child
