// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/thread_option.hpp"

#include <cmath>
#include <optional>

#include "geometry/brep/input_error.hpp"

namespace abut {

namespace {

constexpr int most_threads = 1024;

}  // namespace

int threads_of(const Arguments& arguments) {
    const std::optional<double> threads = positive_number(arguments, "--threads");
    if (!threads) return 0;
    if (*threads != std::floor(*threads) || *threads > most_threads)
        throw InputError("--threads", "is to be a whole number from 1 to " + std::to_string(most_threads), "");
    return static_cast<int>(*threads);
}

}  // namespace abut
