// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

/// Forces and moments without balance, of the largest resultant, and violations of the conditions of contact: what the coarsest
/// accuracy level would not leave of anything else.
constexpr double largest_residual = 1e-2;

bool has_reason(const Result& result, const std::string& kind) {
    return std::any_of(result.reasons.begin(), result.reasons.end(), [&](const Reason& r) { return r.kind == kind; });
}

bool finite(double v) {
    return std::isfinite(v);
}
bool finite(const Vec2& v) {
    return v.allFinite();
}
bool finite(const ValueAt& v) {
    return finite(v.value) && finite(v.at);
}
bool finite(const Stress& s) {
    return finite(s.xx) && finite(s.yy) && finite(s.xy) && finite(s.zz);
}
bool finite(const FieldSample& s) {
    return finite(s.displacement) && finite(s.stress);
}
bool finite(const ContactErrors& e) {
    return finite(e.pressure) && finite(e.peak) && finite(e.force);
}
template <class T>
bool finite(const std::optional<T>& value) {
    return !value || finite(*value);
}
template <class T>
bool finite(const std::vector<T>& values) {
    return std::all_of(values.begin(), values.end(), [](const T& v) { return finite(v); });
}
bool finite(const ContactProfile& p) {
    return finite(p.s) && finite(p.x) && finite(p.y) && finite(p.pressure) && finite(p.gap) && finite(p.shear) &&
           finite(p.slip);
}
bool finite(const ContactResult& c) {
    return finite(c.gap_min) && finite(c.gap_max) && finite(c.force) && finite(c.moment) && finite(c.contact_length) &&
           finite(c.ends) && finite(c.max_pressure) && finite(c.max_penetration) && finite(c.error_estimate) &&
           finite(c.errors) && finite(c.profile);
}
bool finite(const PartField& f) {
    return finite(f.samples) && std::all_of(f.boundary.begin(), f.boundary.end(), [](const auto& b) { return finite(b); });
}
bool finite(const Reaction& r) {
    return finite(r.force) && finite(r.moment) && finite(r.force_from_stress) && finite(r.energy);
}

std::vector<std::string> not_finite_in(const Result& r) {
    std::vector<std::string> names;
    const auto check = [&](bool is_finite, const std::string& name) {
        if (!is_finite) names.push_back(name);
    };
    for (std::size_t i = 0; i < r.parts.size(); ++i)
        check(finite(r.parts[i].max_displacement) && finite(r.parts[i].max_von_mises) &&
                  (i >= r.fields.size() || finite(r.fields[i])),
              "part " + r.parts[i].name);
    for (std::size_t k = 0; k < r.contacts.size(); ++k) check(finite(r.contacts[k]), "contact " + contact_number(k));
    for (const Reaction& reaction : r.reactions) check(finite(reaction), "the reaction of " + reaction.label);
    for (const ProbeResult& p : r.probes) check(finite(p.displacement) && finite(p.stress), "the probe in part " + p.part);
    const auto& e = r.equilibrium;
    check(finite(e.applied) && finite(e.reaction) && finite(e.relative_residual) && finite(e.relative_moment_residual),
          "the balance of forces");
    check(finite(r.strain_energy), "the strain energy");
    check(finite(r.error_estimate.energy) && finite(r.error_estimate.contact_pressure) && finite(r.error_estimate.stress) &&
              finite(r.accuracy.estimate),
          "the estimated errors");
    check(finite(r.solver.condition_estimate), "the condition number");
    check(finite(r.solver.contact_residual), "the conditions of contact");
    return names;
}

void add(std::string& text, const std::string& more) {
    text += (text.empty() ? "" : "; ") + more;
}

/// "contact pressures known to 0.7 %"; empty without an estimate.
std::string known_words(const Result& result) {
    if (!result.accuracy.estimate) return "";
    const bool contact = result.accuracy.of == "contact pressure";
    return (contact ? "contact pressures known to " : "stresses known to ") + percent_text(*result.accuracy.estimate) +
           (contact ? has_reason(result, "corner") ? " away from corners" : "" : " in the energy norm");
}

}  // namespace

Verdict verdict_of(const Result& result) {
    if (result.status != "ok") return Verdict::failed;
    return result.reasons.empty() ? Verdict::reached : Verdict::solved_but;
}

std::string verdict_word(Verdict verdict) {
    if (verdict == Verdict::failed) return "failed";
    return verdict == Verdict::reached ? "reached" : "solved_but";
}

std::string reasons_text(const Result& result) {
    std::string text;
    for (const Reason& reason : result.reasons) add(text, reason.text);
    return text;
}

std::string verdict_sentence(const Result& result) {
    const Verdict verdict = verdict_of(result);
    if (verdict == Verdict::failed) return "Failed: " + (result.message.empty() ? "no reason was given" : result.message);
    std::string words = reasons_text(result);
    if (!known_words(result).empty() && !has_reason(result, "accuracy")) add(words, known_words(result));
    const std::string begin = verdict == Verdict::solved_but ? "Solved, but"
                              : result.accuracy.reached      ? "Solved, accuracy reached"
                                                             : "Solved";
    return begin + (words.empty() ? "" : ": " + words);
}

std::string impossible_in(const Result& result) {
    std::string text;
    if (const std::vector<std::string> names = not_finite_in(result); !names.empty())
        add(text, "numbers are not finite (" + first_few(names) + ")");
    if (result.strain_energy < -result.energy_rounding)
        add(text, "the strain energy is below zero (" + number_text(result.strain_energy, 3) + ")");
    if (result.solver.contact_residual.value_or(0) > largest_residual)
        add(text, "the conditions of contact are violated by " + percent_text(*result.solver.contact_residual) +
                      " of the largest pressure or closing");
    if (result.equilibrium.relative_residual > largest_residual)
        add(text, "forces are out of balance by " + percent_text(result.equilibrium.relative_residual) + " of the largest");
    if (result.equilibrium.relative_moment_residual > largest_residual)
        add(text, "moments are out of balance by " + percent_text(result.equilibrium.relative_moment_residual) +
                      " of the largest force times the model's size");
    return text;
}

}  // namespace abut
