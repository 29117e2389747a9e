// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/batch_options.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

constexpr int most_workers = 4096;
constexpr double longest_timeout = 1e8;
constexpr double least_memory =
    256e6;  // the linear algebra library alone may ask for 128 MiB at once, and asks until it gets them

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

std::size_t usual_workers() {
    const std::optional<double> given = to_number(variable("SLURM_CPUS_PER_TASK"));
    if (given && *given >= 1 && *given <= most_workers) return static_cast<std::size_t>(*given);
    return std::max(1U, std::thread::hardware_concurrency());
}

double unit_of(char letter) {
    switch (letter) {
        case 'K':
        case 'k':
            return 1024.0;
        case 'M':
        case 'm':
            return 1024.0 * 1024;
        case 'G':
        case 'g':
            return 1024.0 * 1024 * 1024;
        default:
            return 0;
    }
}

}  // namespace

std::size_t workers_of(const Arguments& arguments) {
    const std::optional<int> workers = whole_number(arguments, "-j", most_workers);
    return workers ? static_cast<std::size_t>(*workers) : usual_workers();
}

double memory_of(const Arguments& arguments) {
    const std::string text = value_or(arguments, "--memory", "");
    if (!has(arguments, "--memory")) return 0;
    const double unit = text.empty() ? 0 : unit_of(text.back());
    const std::optional<double> number = unit > 0 ? to_number(text.substr(0, text.size() - 1)) : std::nullopt;
    if (!number || *number <= 0)
        throw InputError("--memory", "'" + shortened(text) + "' is no amount of memory", "write it as in 500M or 2G");
    if (*number * unit < least_memory)
        throw InputError("--memory", "'" + shortened(text) + "' is too little for any job", "give at least 256M");
    return *number * unit;
}

unsigned timeout_of(const Arguments& arguments) {
    const double seconds = positive_number(arguments, "--timeout").value_or(0);
    if (seconds > longest_timeout)
        throw InputError("--timeout", "is to be a number of seconds below 1e8", "leave it out for no limit");
    return static_cast<unsigned>(std::ceil(seconds));
}

Shard shard_of(const Arguments& arguments) {
    if (has(arguments, "--shard")) return parse_shard(arguments.options.at("--shard"));
    return slurm_shard(variable).value_or(Shard{});
}

}  // namespace abut
