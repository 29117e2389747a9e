// SPDX-License-Identifier: GPL-3.0-or-later
// batch.json: which batch an output folder belongs to. All shards of a batch write the same one.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "src/batch_source.hpp"

namespace abut {

struct BatchFile {
    std::string source;                           ///< as it was given; for titles
    std::map<std::string, std::string> settings;  ///< all that answers depend on but files and parameters: version, options
    struct Job {
        std::string name, file;
    };
    std::vector<Job> jobs;  ///< of all shards, in their order
};

BatchFile batch_file(const std::string& source, const std::map<std::string, std::string>& settings,
                     const std::vector<BatchJob>& jobs);

std::string batch_json(const BatchFile& batch);
/// That of an output folder. Throws InputError where there is none or it is wrong.
BatchFile read_batch_file(const std::string& out);

/// What two of them disagree in, in words; empty: they are shards of one batch. Places of files may differ.
std::string difference(const BatchFile& a, const BatchFile& b);

}  // namespace abut
