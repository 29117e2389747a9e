// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `batch` that are numbers with a meaning of their own.
#pragma once
#include <cstddef>

#include "apps/arguments.hpp"
#include "src/batch/batch_shard.hpp"

namespace abut {

/// The number of workers: -j; without it what Slurm gives a task (SLURM_CPUS_PER_TASK), else the processors that this process
/// may use. Throws InputError.
std::size_t workers_of(const Arguments& arguments);
/// The value of --memory in bytes: "500M", "2G"; 0 where it is not given. Throws InputError.
double memory_of(const Arguments& arguments);
/// The value of --timeout in whole seconds, 0 where it is not given. Throws InputError.
unsigned timeout_of(const Arguments& arguments);
/// The shard of --shard; without it that of the Slurm job array that this is a task of, else the whole. Throws InputError.
Shard shard_of(const Arguments& arguments);

}  // namespace abut
