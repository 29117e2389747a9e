// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/case_result.hpp"

#include <algorithm>

#include "src/results/displacement_from_drawn.hpp"

namespace abut {

namespace {

void raise(CaseValue& largest, double value, const Vec2& at, std::size_t in_case) {
    if (value > largest.value) largest = {value, at, in_case};
}

bool is_of(const ContactEnvelope& e, const ContactResult& contact) {
    return e.parts == contact.parts && e.edges == contact.edges;
}

/// That of the `which`-th contact of these edges in a case, made where there is none.
ContactEnvelope& envelope_for(const ContactResult& contact, int which, std::vector<ContactEnvelope>& all) {
    for (ContactEnvelope& e : all)
        if (is_of(e, contact) && which-- == 0) return e;
    all.emplace_back();
    all.back().parts = contact.parts;
    all.back().edges = contact.edges;
    return all.back();
}

void add(const Result& result, std::size_t in_case, Envelope& all) {
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const ContactResult& contact = result.contacts[k];
        if (contact.edges[0].empty()) continue;  // of parts that were not analysed: nothing acts on them
        const auto of_same_edges = [&](const ContactResult& c) { return c.parts == contact.parts && c.edges == contact.edges; };
        const auto before =
            std::count_if(result.contacts.begin(), result.contacts.begin() + static_cast<std::ptrdiff_t>(k), of_same_edges);
        ContactEnvelope& e = envelope_for(contact, static_cast<int>(before), all.contacts);
        raise(e.max_pressure, contact.max_pressure.value, contact.max_pressure.at, in_case);
        raise(e.force, contact.force.norm(), {0, 0}, in_case);
        raise(e.contact_length, contact.contact_length, {0, 0}, in_case);
        if (contact.status == "open") e.open_in.push_back(in_case);
    }
    for (std::size_t i = 0; i < result.parts.size(); ++i) {
        const PartResult& part = result.parts[i];
        PartEnvelope& e = all.parts[i];
        raise(e.max_von_mises, part.max_von_mises.value, part.max_von_mises.at, in_case);
        const ValueAt displacement = displacement_from_drawn(result, i);
        raise(e.max_displacement, displacement.value, displacement.at, in_case);
        if (!part.utilisation) continue;
        if (!e.utilisation) e.utilisation = CaseValue{*part.utilisation, part.max_von_mises.at, in_case};
        raise(*e.utilisation, *part.utilisation, part.max_von_mises.at, in_case);
    }
}

}  // namespace

Envelope envelope_of(const std::vector<CaseResult>& cases) {
    Envelope all;
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const Result& result = cases[k].result;
        if (result.status != "ok") continue;
        if (all.parts.empty())
            for (const PartResult& part : result.parts) all.parts.push_back({part.name, {0, {0, 0}, k}, {0, {0, 0}, k}, {}});
        add(result, k, all);
    }
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
