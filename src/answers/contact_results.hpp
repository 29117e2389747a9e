// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// What one contact of a solved assembly does, on the model's own edges.
ContactResult contact_result(const Scene& scene, const SolvedAssembly& solved, const Candidate& candidate, std::size_t contact);

/// The word for what these stretches under pressure make of a contact: "closed", "partial", "open".
std::string contact_status(const ContactInterface& contact, const std::vector<PressedStretch>& stretches);

}  // namespace abut
