// SPDX-License-Identifier: GPL-3.0-or-later
// A template: a scene some of whose imports name the file `any_file` ("*"), which is another one in each job.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/batch/batch_source.hpp"

namespace abut {

struct BatchTemplate {
    std::string file;
    bool takes_file = false;              ///< it names `any_file`
    std::vector<std::string> parameters;  ///< those that it has
    std::vector<std::string> unused;      ///< those of them that nothing of it uses
};

/// Reads a template. Throws InputError where it cannot be read as JSON; the rest of it only shows with a drawing.
BatchTemplate read_template(const std::string& file);

/// Checks that source and template go together. Throws InputError where every job would fail for the same reason: a template
/// without a place for the files, columns that are no parameters of it, jobs without a file or template. `batch_template` is
/// null without one.
void check_template(const BatchSource& source, const BatchTemplate* batch_template);

}  // namespace abut
