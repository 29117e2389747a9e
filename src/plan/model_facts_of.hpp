// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/results/model_facts.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// What a Scene no longer knows of the files that it was read from.
struct ModelSources {
    std::vector<HashedFile> files;        ///< the scene's own, and those that it imports
    std::vector<bool> default_thickness;  ///< by part: neither it nor the scene gives one
};

/// To be asked for right after the scene was read, as long as its files are what was read.
ModelSources model_sources(const Scene& scene);

/// What the scene gives, for those who read the answer. Throws InputError as resolve_conditions does.
ModelFacts model_facts(const Scene& scene, const ModelSources& sources);

}  // namespace abut
