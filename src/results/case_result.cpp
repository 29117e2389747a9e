// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/case_result.hpp"

#include <algorithm>

namespace abut {

namespace {

void raise(CaseValue& largest, double value, const Vec2& at, std::size_t in_case) {
    if (value > largest.value) largest = {value, at, in_case};
}

/// That of the edges of a contact, made where there is none.
ContactEnvelope& envelope_for(const ContactResult& contact, std::vector<ContactEnvelope>& all) {
    const auto is_same = [&](const ContactEnvelope& e) { return e.parts == contact.parts && e.edges == contact.edges; };
    const auto found = std::find_if(all.begin(), all.end(), is_same);
    if (found != all.end()) return *found;
    all.emplace_back();
    all.back().parts = contact.parts;
    all.back().edges = contact.edges;
    return all.back();
}

void add(const Result& result, std::size_t in_case, Envelope& all) {
    for (const ContactResult& contact : result.contacts) {
        ContactEnvelope& e = envelope_for(contact, all.contacts);
        raise(e.max_pressure, contact.max_pressure.value, contact.max_pressure.at, in_case);
        raise(e.force, contact.force.norm(), {0, 0}, in_case);
        raise(e.contact_length, contact.contact_length, {0, 0}, in_case);
        if (contact.status == "open") e.open_in.push_back(in_case);
    }
    for (std::size_t i = 0; i < result.parts.size(); ++i) {
        const PartResult& part = result.parts[i];
        PartEnvelope& e = all.parts[i];
        raise(e.max_von_mises, part.max_von_mises.value, part.max_von_mises.at, in_case);
        raise(e.max_displacement, part.max_displacement.value, part.max_displacement.at, in_case);
        if (!part.utilisation) continue;
        if (!e.utilisation) e.utilisation = CaseValue{*part.utilisation, part.max_von_mises.at, in_case};
        raise(*e.utilisation, *part.utilisation, part.max_von_mises.at, in_case);
    }
}

}  // namespace

Envelope envelope_of(const std::vector<CaseResult>& cases) {
    Envelope all;
    if (cases.empty()) return all;
    for (const PartResult& part : cases.front().result.parts) all.parts.push_back({part.name, {}, {}, {}});
    for (std::size_t k = 0; k < cases.size(); ++k)
        if (cases[k].result.status == "ok") add(cases[k].result, k, all);
    return all;
}

Verdict verdict_of(const std::vector<CaseResult>& cases) {
    Verdict worst = Verdict::reached;
    for (const CaseResult& c : cases) worst = std::max(worst, verdict_of(c.result));
    return worst;
}

std::string case_folder(std::size_t k) {
    return "case_" + std::to_string(k + 1);
}

}  // namespace abut
