// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_contacts.hpp"

#include <utility>

#include "src/scene/read_selection.hpp"

namespace abut {

namespace {

std::optional<PairRule> read_pair(SceneReading& reading, const JsonValue& value) {
    const std::size_t before = reading.problems.size();
    if (!check_object(reading, value, {{"between", "kind", "interference"}, {}})) return std::nullopt;
    PairRule rule;
    rule.where = value.pointer;
    const JsonValue* between = required(reading, value, "between");
    if (between && (between->kind != JsonValue::Kind::array || between->items.size() != 2)) {
        report_problem(reading, *between, "expected two selections of edges, found " + described(*between));
    } else if (between) {
        for (std::size_t i : {0u, 1u}) rule.between[i] = read_selector(reading, between->items[i]).value_or(Selector{});
    }
    const JsonValue* kind = find_member(value, "kind");
    const auto word = kind ? read_word(reading, *kind, {{"contact", "bonded", "ignore"}, {}}) : std::nullopt;
    if (word == "ignore") rule.kind = PairRule::Kind::ignore;
    if (word == "bonded") rule.kind = PairRule::Kind::bonded;
    rule.interference = member_or(reading, value, "interference", 0.0, read_number, dimension::length);
    if (const JsonValue* interference = find_member(value, "interference"); interference && word == "bonded")
        report_problem(reading, *interference, "bonded edges are held together as they are drawn: they have no interference",
                       "take it away, or make the pair a contact");
    if (reading.problems.size() > before) return std::nullopt;
    return rule;
}

void check_friction(SceneReading& reading, const JsonValue& value) {
    const std::optional<double> friction = read_number(reading, value, dimension::none);
    if (friction && *friction != 0) report_problem(reading, value, "'friction' is not supported yet", "only 0 is");
}

/// "penalty": the formulation's options; "auto", "mortar": none, and its keys do not belong there.
std::optional<PenaltyOptions> read_penalty(SceneReading& reading, const JsonValue& contacts) {
    const JsonValue* formulation = find_member(contacts, "formulation");
    const bool is_penalty = formulation && read_word(reading, *formulation, {{"auto", "mortar", "penalty"}, {}}) == "penalty";
    PenaltyOptions options;
    options.factor = member_or(reading, contacts, "penalty", options.factor, read_positive, dimension::none);
    if (const JsonValue* length = find_member(contacts, "penalty_length"))
        options.length = read_positive(reading, *length, dimension::length);
    if (is_penalty) return options;
    for (const char* key : {"penalty", "penalty_length"})
        if (const JsonValue* member = find_member(contacts, key))
            report_problem(reading, *member, "'" + std::string(key) + "' belongs to the penalty formulation",
                           "give \"formulation\": \"penalty\", or leave it out");
    return std::nullopt;
}

}  // namespace

ContactOptions read_contacts(SceneReading& reading, const JsonValue& contacts) {
    ContactOptions options;
    const Words keys{{"detect", "search_distance", "formulation", "penalty", "penalty_length", "friction", "overlap", "pairs"},
                     {}};
    if (!check_object(reading, contacts, keys)) return options;
    options.detect = member_or(reading, contacts, "detect", options.detect, read_flag);
    const JsonValue* distance = find_member(contacts, "search_distance");
    const bool automatic = distance && distance->kind == JsonValue::Kind::string && distance->text == "auto";
    if (distance && !automatic) options.search_distance = read_positive(reading, *distance, dimension::length);
    options.penalty = read_penalty(reading, contacts);
    if (const JsonValue* friction = find_member(contacts, "friction")) check_friction(reading, *friction);
    options.overlap = member_or(reading, contacts, "overlap", options.overlap, [](SceneReading& r, const JsonValue& v) {
        return read_word(r, v, {{"report", "press_fit", "ignore"}, {}});
    });
    const JsonValue* pairs = find_member(contacts, "pairs");
    if (!pairs || !check_list(reading, *pairs, 0, "pairs")) return options;
    for (const JsonValue& item : pairs->items) {
        if (auto rule = read_pair(reading, item)) options.pairs.push_back(std::move(*rule));
    }
    return options;
}

}  // namespace abut
