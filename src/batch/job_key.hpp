// SPDX-License-Identifier: GPL-3.0-or-later
// What the answer of a job depends on, in one short text: the same key, the same answer.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "src/io/content_hash.hpp"
#include "src/io/file_stamp.hpp"

namespace abut {

/// A file that is read, and the hash of its contents; "missing" where it is not there.
struct InputFile {
    std::string path, hash;
    FileStamp stamp{};        ///< from before it was read
    bool was_recent = false;  ///< then
};

/// The file and those that it names if it is JSON (a scene's imports, the buffers of glTF), which are relative to it; the name
/// `any_file` of templates left out. What cannot be parsed names nothing.
std::vector<InputFile> input_files(const std::string& file);

/// Are the files still what they were when `input_files` read them? Cost: a look-up each; those that had just been written then
/// are read again.
bool are_unchanged(const std::vector<InputFile>& inputs);

/// The key of settings and of the contents (not the places) of files.
std::string job_key(const std::map<std::string, std::string>& settings, const std::vector<InputFile>& inputs);

}  // namespace abut
