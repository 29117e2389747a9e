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
    if (!has(arguments, "--threads")) return 0;
    const std::optional<double> threads = to_number(arguments.options.at("--threads"));
    if (!threads || *threads != std::floor(*threads) || *threads < 1 || *threads > most_threads)
        throw InputError("--threads", "is to be a whole number from 1 to " + std::to_string(most_threads), "");
    return static_cast<int>(*threads);
}

}  // namespace abut
