// SPDX-License-Identifier: GPL-3.0-or-later
// Which jobs of a batch are whose, where several machines share it.
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace abut {

/// The index-th of `count` shares of a batch.
struct Shard {
    std::size_t index = 1, count = 1;  ///< index from 1 to count
};

/// Reads a shard as it is written, "3/8". Throws InputError.
Shard parse_shard(const std::string& text);

/// The shard that a task of a Slurm job array is, by the variables SLURM_ARRAY_TASK_ID, _COUNT, _MIN, _STEP as `variable` gives
/// them (empty: not set); nothing outside of arrays. Throws InputError where the array has gaps: its tasks cannot tell which
/// ones they are.
std::optional<Shard> slurm_shard(const std::function<std::string(const char*)>& variable);

/// Is the job one of the shard's? Jobs go round: neighbours, which often take similar time, go to different shards.
inline bool is_in(const Shard& shard, std::size_t job) {
    return job % shard.count == shard.index - 1;
}

}  // namespace abut
