// SPDX-License-Identifier: GPL-3.0-or-later
// The shards of a batch put together.
#pragma once
#include <string>
#include <vector>

#include "src/batch/batch_file.hpp"

namespace abut {

/// Brings the finished jobs of all folders into `out`, which may be one of them: links to the files where the file system can,
/// else copies. Returns the batch. Throws InputError with all that speaks against it, before anything is written: folders of
/// different batches, a job that two of them have with different inputs. Throws StoreError where nothing can be written. A job
/// that did not end by itself counts only where no other folder has it.
BatchFile merge_batches(const std::vector<std::string>& folders, const std::string& out);

}  // namespace abut
