// SPDX-License-Identifier: GPL-3.0-or-later
// How the answer's quantities are put into words: units out of the scene's labels, values, points, lists.
#pragma once
#include <string>
#include <vector>

#include "src/results/result.hpp"

namespace abut {

/// Unit labels; each may be empty where the scene names no units.
struct ResultUnits {
    std::string length, area, force, moment, stress, energy;
};
/// Stress is force / length^2, by its usual name where it has one (N, mm: MPa; N, m: Pa; lbf, in: psi). Plane quantities are
/// totals over the thickness, so that moment and energy are force x length.
ResultUnits result_units(const Result& result);

/// A value with its unit: "132 MPa", with the given number of significant digits; the value alone without a unit.
std::string with_unit(double value, int digits, const std::string& unit);
/// A heading with its unit: "pressure [MPa]", or "pressure" without a unit.
std::string heading(const std::string& quantity, const std::string& unit);
/// A value, but 0 for what is rounding beside the largest of its kind (below 1e-9 of it).
double rounded_off(double value, double largest);
/// The part with the largest von Mises stress; nullptr where nothing is strained.
const PartResult* most_stressed(const Result& result);
/// A part's largest von Mises stress in words: "39.8 MPa ± 2 %", or "39.8 MPa at a corner".
std::string largest_stress_text(const PartResult& part, int digits, const std::string& unit);
/// A pair in words: "(0, 39.95)"; a component that is rounding beside the other is 0.
std::string pair_text(const Vec2& v, int digits);
/// A point of the model, to about 1e-5 of its size (0: six digits): "(0, 39.95)".
std::string place_text(const Vec2& p, double model_size);
/// The diagonal of all parts' common box, 0 without geometry.
double model_size(const Result& result);
/// The number of the k-th contact for people, from 1: in tables, pictures and the name of contact_<k>.csv.
std::string contact_number(std::size_t k);
std::string joined(const std::vector<std::string>& items, const std::string& separator);
/// A count in words: "2 contacts", "1 contact".
std::string counted(std::size_t n, const std::string& singular);
/// Seconds in words: "0.12 s" or "3.4 ms"; empty where the stage was not timed.
std::string seconds_text(double seconds);
/// The time of a stage, 0 where it is not there.
double stage_seconds(const Result& result, const std::string& stage);
}  // namespace abut
