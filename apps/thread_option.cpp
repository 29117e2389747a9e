// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/thread_option.hpp"

namespace abut {

int threads_of(const Arguments& arguments) {
    constexpr int most_threads = 1024;
    return whole_number(arguments, "--threads", most_threads).value_or(0);
}

}  // namespace abut
