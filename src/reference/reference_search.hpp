// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/reference/reference.hpp"

namespace abut {

/// An entry and the page that it stands on; they live as long as the pages that were searched.
struct FoundEntry {
    const ReferencePage* page = nullptr;
    const ReferenceEntry* entry = nullptr;
};

/// The keys that a user may mean: a file by its title ("contacts.json"); a key by the whole path ("loads.force",
/// "scene.loads[].force", "materials.steel.E"), else by its end
/// ("omega"), else by some of its words in their order ("result.contacts.pressure"). Brackets may be left out. Empty: none.
std::vector<FoundEntry> find_keys(const std::vector<ReferencePage>& pages, const std::string& words);

/// A path as people write it: "materials.E" of "materials.*.E", "loads.force" of "loads[].force".
std::string plain_path(const std::string& path);

/// What to write instead of words that mean no key and none of the other names: "did you mean 'loads.force'?".
std::string nearest_key_hint(const std::vector<ReferencePage>& pages, const std::string& words,
                             const std::vector<std::string>& other_names);

}  // namespace abut
