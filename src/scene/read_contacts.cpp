// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_contacts.hpp"

#include <limits>
#include <utility>

#include "src/io/number_text.hpp"
#include "src/scene/read_selection.hpp"

namespace abut {

namespace {

/// A coefficient of friction: a number >= 0, or "rough". A large one is possible, but more often a percentage.
std::optional<double> read_friction(SceneReading& reading, const JsonValue& value, std::vector<std::string>& warnings) {
    constexpr double plausible = 5;
    if (value.kind == JsonValue::Kind::string && value.text == "rough") return std::numeric_limits<double>::infinity();
    const std::optional<double> friction = read_number(reading, value, dimension::none);
    if (!friction) return std::nullopt;
    if (*friction < 0) {
        report_problem(reading, value, "a coefficient of friction is not negative",
                       "give a number from 0, or \"rough\" for faces that do not slip");
        return std::nullopt;
    }
    if (*friction > plausible)
        warnings.push_back(value.pointer + ": a coefficient of friction of " + number_text(*friction, 3) +
                           " is more than any pair of materials has; \"rough\" is the word for faces that do not slip");
    return friction;
}

std::optional<PairRule> read_pair(SceneReading& reading, const JsonValue& value, std::vector<std::string>& warnings) {
    const std::size_t before = reading.problems.size();
    if (!check_object(reading, value, {"between", "kind", "interference", "friction"})) return std::nullopt;
    PairRule rule;
    rule.where = value.pointer;
    const JsonValue* between = required(reading, value, "between");
    if (between && (between->kind != JsonValue::Kind::array || between->items.size() != 2)) {
        report_problem(reading, *between, "expected two selections of edges, found " + described(*between));
    } else if (between) {
        for (std::size_t i : {0u, 1u}) rule.between[i] = read_selection(reading, between->items[i]).value_or(Selection{});
    }
    const JsonValue* kind = find_member(value, "kind");
    const auto word = kind ? read_word(reading, *kind, {"contact", "bonded", "ignore"}) : std::nullopt;
    if (word == "ignore") rule.kind = PairRule::Kind::ignore;
    if (word == "bonded") rule.kind = PairRule::Kind::bonded;
    rule.interference = member_or(reading, value, "interference", 0.0, read_number, dimension::length);
    if (const JsonValue* interference = find_member(value, "interference"); interference && word == "bonded")
        report_problem(reading, *interference, "bonded edges are held together as they are drawn: they have no interference",
                       "take it away, or make the pair a contact");
    if (const JsonValue* friction = find_member(value, "friction")) {
        rule.friction = read_friction(reading, *friction, warnings);
        if (word == "bonded" || word == "ignore")
            report_problem(reading, *friction,
                           "edges that are " + std::string(word == "bonded" ? "bonded" : "left alone") + " have no friction",
                           "take it away, or make the pair a contact");
    }
    if (reading.problems.size() > before) return std::nullopt;
    return rule;
}

/// "penalty": the formulation's options; "auto", "mortar": none, and its keys do not belong there.
std::optional<PenaltyOptions> read_penalty(SceneReading& reading, const JsonValue& contacts) {
    const JsonValue* formulation = find_member(contacts, "formulation");
    const bool is_penalty = formulation && read_word(reading, *formulation, {"auto", "mortar", "penalty"}) == "penalty";
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

ContactOptions read_contacts(SceneReading& reading, const JsonValue& contacts, std::vector<std::string>& warnings) {
    ContactOptions options;
    const Words keys{"detect", "search_distance", "formulation", "penalty", "penalty_length", "friction", "overlap", "pairs"};
    if (!check_object(reading, contacts, keys)) return options;
    options.detect = member_or(reading, contacts, "detect", options.detect, read_flag);
    const JsonValue* distance = find_member(contacts, "search_distance");
    const bool automatic = distance && distance->kind == JsonValue::Kind::string && distance->text == "auto";
    if (distance && !automatic) options.search_distance = read_positive(reading, *distance, dimension::length);
    options.penalty = read_penalty(reading, contacts);
    if (const JsonValue* friction = find_member(contacts, "friction"))
        options.friction = read_friction(reading, *friction, warnings).value_or(0);
    options.overlap = member_or(reading, contacts, "overlap", options.overlap, [](SceneReading& r, const JsonValue& v) {
        return read_word(r, v, {"report", "press_fit", "ignore"});
    });
    const JsonValue* pairs = find_member(contacts, "pairs");
    if (pairs && check_list(reading, *pairs, 0, "pairs"))
        for (const JsonValue& item : pairs->items)
            if (auto rule = read_pair(reading, item, warnings)) options.pairs.push_back(std::move(*rule));
    return options;
}

void refuse_friction_where_unknown(SceneReading& reading, const Scene& scene) {
    const bool is_structured = scene.accuracy.dirichlet == "solution_structure";
    if (!scene.contacts.penalty && !is_structured) return;
    const auto refuse = [&](const std::string& in) {
        const JsonValue& friction = *find_pointer(reading.root, in + "/friction");
        if (scene.contacts.penalty)
            report_problem(reading, friction, "penalty contact has no friction",
                           "take the friction away, or the penalty formulation (accuracy.method dissertation has it, too)");
        else
            report_problem(reading, friction, "parts held by a solution structure have no friction",
                           "take the friction away, or accuracy.dirichlet");
    };
    if (scene.contacts.friction != 0) refuse("/contacts");
    for (const PairRule& rule : scene.contacts.pairs)
        if (rule.friction.value_or(0) != 0) refuse(rule.where);
}

}  // namespace abut
