// SPDX-License-Identifier: GPL-3.0-or-later
// The reference for people: an entry on a terminal, pages for the repository, sections of a man page.
#pragma once
#include <string>
#include <vector>

#include "src/reference/reference.hpp"

namespace abut {

/// "The material." of "The material. It may be rigid."
std::string first_sentence(const std::string& meaning);

/// What `abut help KEY` prints: name, type, unit, default, meaning, example (its own, else one of the object that has
/// it), and the keys below it.
std::string entry_text(const ReferencePage& page, const ReferenceEntry& entry);

/// data/schema/README.md: a table of keys for each object.
std::string reference_markdown(const std::vector<ReferencePage>& pages);

/// Sections of a man page, in roff.
std::string reference_roff(const std::vector<ReferencePage>& pages);

/// A text whose characters mean nothing to roff; each of its lines stays one.
std::string roff_escaped(const std::string& text);

}  // namespace abut
