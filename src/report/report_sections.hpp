// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of the report. Each is a piece of HTML made from the result alone; ids of clip paths are unique in the page.
#pragma once
#include <string>
#include <vector>

#include "src/report/svg.hpp"
#include "src/results/model_facts.hpp"
#include "src/results/result.hpp"

namespace abut::report {

inline constexpr double page_width = 1120;  ///< pixels of the text column
inline constexpr double half_width = 548;   ///< of pictures that stand side by side

/// The parts' common box, undeformed.
Box2 model_box(const Result& result);
/// How many times as large pictures draw displacements: 1, 2 or 5 times a power of ten, so that the largest is about a
/// twentieth of the model's diagonal.
double drawn_exaggeration(const Result& result);
/// The size of pictures of the whole model: side by side unless the model is a strip.
struct PictureSize {
    double width, max_height;
};
PictureSize picture_size(const Box2& model);

/// The verdict in one sentence, what there is in another; the notes, and the box with warnings (report_verdict.cpp).
std::string verdict_box(const Result& result);
std::string warnings_box(const Result& result);

/// model: the loads, whose values stand at their arrows.
std::string assembly_section(const Result& result, const ModelFacts& model);
std::string fields_section(const Result& result);
/// The contacts of the largest pressures, at most so many.
std::vector<bool> strongest_contacts(const Result& result, std::size_t n);
/// Which contacts have pictures: the strongest.
std::vector<bool> pictured_contacts(const Result& result);
/// The contacts in words, and the pressure curves and close-ups of those that have pictures.
std::string contacts_section(const Result& result);
std::string tables_section(const Result& result);
/// The errors aimed at and reached (report_accuracy.cpp); empty without an estimate.
std::string accuracy_table(const Result& result);
/// What supports and contacts leave the parts to do; empty before that is known.
std::string mobility_table(const Result& result);

std::string stress_figure(const Result& result, const PictureSize& size);
std::string deformed_figure(const Result& result, const PictureSize& size);
/// The pressure and gap of a contact against arc length (report_curves.cpp); empty without a profile.
std::string contact_curves(const Result& result, std::size_t contact);
/// The stress around the contact with the pressure drawn on its edge (report_closeup.cpp); empty without a profile.
std::string contact_closeup(const Result& result, std::size_t contact);

/// What was analysed (report_model.cpp); empty for a result that was not made from a scene.
std::string model_section(const Result& result, const ModelFacts& model);

}  // namespace abut::report
