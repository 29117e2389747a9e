// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_shard.hpp"

#include <charconv>
#include <system_error>

#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

std::optional<std::size_t> whole_number(const std::string& text) {
    std::size_t number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && stop == end && !text.empty() ? std::optional(number) : std::nullopt;
}

}  // namespace

Shard parse_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto index = whole_number(text.substr(0, slash));
    const auto count = slash == std::string::npos ? std::nullopt : whole_number(text.substr(slash + 1));
    if (!index || !count || *index < 1 || *index > *count)
        throw InputError("--shard", "'" + shortened(text) + "' is no shard", "shards of four are 1/4, 2/4, 3/4 and 4/4");
    return {*index, *count};
}

std::optional<Shard> slurm_shard(const std::function<std::string(const char*)>& variable) {
    const auto id = whole_number(variable("SLURM_ARRAY_TASK_ID")), count = whole_number(variable("SLURM_ARRAY_TASK_COUNT"));
    if (!id || !count) return std::nullopt;
    const std::size_t least = whole_number(variable("SLURM_ARRAY_TASK_MIN")).value_or(1);
    const std::size_t step = whole_number(variable("SLURM_ARRAY_TASK_STEP")).value_or(1);
    const auto last = whole_number(variable("SLURM_ARRAY_TASK_MAX"));
    const std::size_t span = step * (*count > 0 ? *count - 1 : 0);
    const bool even =
        step > 0 && *id >= least && (*id - least) % step == 0 && *id - least <= span && (!last || *last - least == span);
    if (!even)
        throw InputError("SLURM_ARRAY_TASK_ID",
                         "the tasks of this job array have gaps, so that task " + std::to_string(*id) + " is no certain shard",
                         "submit an array without gaps, as in --array=1-8, or give --shard");
    return Shard{(*id - least) / step + 1, *count};
}

}  // namespace abut
