// SPDX-License-Identifier: GPL-3.0-or-later
// Signs for contacts, supports and loads in the pictures.
#pragma once
#include <string>
#include <vector>

#include "src/report/report_labels.hpp"
#include "src/report/svg.hpp"
#include "src/results/model_facts.hpp"
#include "src/results/result.hpp"

namespace abut::report {

inline constexpr const char* contact_color = "#d3102b";
inline constexpr const char* candidate_color = "#f08300";
inline constexpr const char* load_color = "#1348b0";
inline constexpr const char* support_color = "#222";

/// A stretch of a contact's edge, in assembly coordinates: closed (it carries pressure) or a candidate that stayed open.
struct ContactStretch {
    std::vector<Vec2> points;
    bool closed;
};
/// The stretches of a contact by its profile; without one, the whole edges by their names, closed unless the contact's status
/// is open.
std::vector<ContactStretch> contact_stretches(const Result& result, const ContactResult& contact);
/// The point where a contact's number is hung: where the pressure is largest, or the middle of the candidate.
Vec2 contact_anchor(const ContactResult& contact, const std::vector<ContactStretch>& stretches);

/// A contact's stretches as thick lines (SVG).
std::string contact_lines(const std::vector<ContactStretch>& stretches, const View& view, double width);
/// A contact's number in a disc, with a leader to the contact.
std::string number_disc(const std::string& number, const Vec2& anchor, LabelPlaces& places);

/// The signs of supports: ground hatching where both components are held, triangles on rollers where one is; thinned out.
/// Blocks its places.
std::string support_signs(const std::vector<SupportMark>& marks, const View& view, LabelPlaces& places);
/// The arrows of loads, which end on the part where they push and start there where they pull; thinned out. Blocks their
/// places.
std::string load_arrows(const Result& result, const View& view, LabelPlaces& places);
/// The loads' values beside their arrows.
std::string load_values(const Result& result, const ModelFacts& model, const View& view, LabelPlaces& places);

}  // namespace abut::report
