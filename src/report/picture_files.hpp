// SPDX-License-Identifier: GPL-3.0-or-later
// The report's main pictures as files of their own.
#pragma once
#include <string>
#include <vector>

#include "src/results/model_facts.hpp"
#include "src/results/result.hpp"

namespace abut {

struct PictureFile {
    std::string name;  ///< without an ending: "assembly", "stress", "displacement", "contact_3"
    std::string svg;
};

/// Those that the report prints, as drawn there, each with its caption: the assembly, von Mises stress, the deformed shape, and
/// of every pictured contact its curves beside its close-up. What there is nothing to show of is left out. model: the
/// loads, for their values.
std::vector<PictureFile> picture_files(const Result& result, const ModelFacts& model = {});

}  // namespace abut
