// SPDX-License-Identifier: GPL-3.0-or-later
// What makes two batches different ones, in words.
#pragma once
#include <string>

#include "src/batch/batch_file.hpp"

namespace abut {

/// A batch and the folder that says it is its own.
struct FolderBatch {
    std::string folder;
    BatchFile batch;
};

/// The first thing in which two batches differ, of: version, options, template, number and names of the jobs, their files and
/// parameters, what is expected of them ("--accuracy is not given in out1 and fine in out2"). Empty: both are shards of one
/// batch. Files may lie in different folders: their own names count.
std::string difference(const FolderBatch& a, const FolderBatch& b);

}  // namespace abut
