// SPDX-License-Identifier: GPL-3.0-or-later
// What was found against what was expected.
#include <algorithm>

#include "src/detect.hpp"
#include "src/json_document.hpp"
#include "src/nearest_name.hpp"

namespace abut {

namespace {

struct Expected {
    std::array<std::string, 2> names;  ///< parts, or edges ("part/edge")
    std::string status, interface;     ///< empty: any
};

/// Collects what is wrong with the file, and throws it all at once.
class ExpectationReader {
public:
    explicit ExpectationReader(const std::string& file) : document_(read_json(file)), problems_(document_.problems) {}

    std::vector<Expected> read() {
        const JsonValue* pairs = find_member(document_.root, "pairs");
        check_keys(document_.root, {"abut", "pairs"});
        if (!pairs || pairs->kind != JsonValue::Kind::array)
            complain(document_.root, "has no list \"pairs\"", "write {\"pairs\": [[\"bracket\", \"pin\"], ...]}");
        std::vector<Expected> expected;
        if (pairs && pairs->kind == JsonValue::Kind::array)
            for (const JsonValue& item : pairs->items) expected.push_back(pair_of(item));
        if (!problems_.empty()) throw InputError(problems_);
        return expected;
    }

private:
    void complain(const JsonValue& value, const std::string& what, const std::string& hint) {
        problems_.push_back({place_of(document_.file, value), what, hint});
    }

    void check_keys(const JsonValue& object, const std::vector<std::string>& known) {
        if (object.kind != JsonValue::Kind::object) return;
        for (const JsonValue& member : object.items)
            if (std::find(known.begin(), known.end(), member.key) == known.end())
                complain(member, "unknown key '" + shortened(member.key) + "'", nearest_name_hint(member.key, known));
    }

    Expected pair_of(const JsonValue& item) {
        Expected expected;
        const bool object = item.kind == JsonValue::Kind::object;
        if (object) {
            const std::vector<std::string> known{"parts", "status", "interface"};
            check_keys(item, known);
            expected.status = text_of(item, "status");
            expected.interface = text_of(item, "interface");
        }
        const JsonValue* names = object ? find_member(item, "parts") : &item;
        if (names && names->kind == JsonValue::Kind::array && names->items.size() == 2 &&
            names->items[0].kind == JsonValue::Kind::string && names->items[1].kind == JsonValue::Kind::string)
            expected.names = {names->items[0].text, names->items[1].text};
        else
            complain(names ? *names : item, "two names of parts or edges expected, found " + described(names ? *names : item),
                     "write [\"bracket\", \"pin\"] or {\"parts\": [\"bracket\", \"pin\"], \"status\": \"touching\"}");
        return expected;
    }

    std::string text_of(const JsonValue& object, const char* key) {
        const JsonValue* value = find_member(object, key);
        if (!value) return {};
        if (value->kind != JsonValue::Kind::string) complain(*value, "a text expected, found " + described(*value), "");
        return value->text;
    }

    JsonDocument document_;
    std::vector<Problem> problems_;
};

bool names_side(const std::string& name, const DetectedPair& pair, std::size_t side) {
    const auto& edges = pair.edges[side];
    return name == pair.parts[side] || std::find(edges.begin(), edges.end(), name) != edges.end();
}

bool names_pair(const Expected& e, const DetectedPair& p) {
    return (names_side(e.names[0], p, 0) && names_side(e.names[1], p, 1)) ||
           (names_side(e.names[1], p, 0) && names_side(e.names[0], p, 1));
}

std::string not_found(const Expected& e, const Detection& detection) {
    const std::string line = "expected " + e.names[0] + " - " + e.names[1] + ", not found";
    for (const DetectedPair& p : detection.near_misses)
        if (names_pair(e, p)) return line + ": " + p.why;
    return line;
}

void compare(const Expected& e, const DetectedPair& p, std::vector<std::string>& differences) {
    const std::string who = p.parts[0] + " - " + p.parts[1] + ": ";
    if (!e.status.empty() && e.status != p.status)
        differences.push_back(who + "status " + p.status + ", expected " + e.status + " (" + p.why + ")");
    if (!e.interface.empty() && e.interface != p.interface)
        differences.push_back(who + "interface " + p.interface + ", expected " + e.interface);
}

}  // namespace

std::vector<std::string> compare_detection(const Detection& detection, const std::string& expectation_file) {
    const std::vector<Expected> expected = ExpectationReader(expectation_file).read();
    std::vector<std::string> differences;
    std::vector<bool> wanted(detection.pairs.size(), false);
    for (const Expected& e : expected) {
        bool found = false;
        for (std::size_t k = 0; k < detection.pairs.size(); ++k) {
            if (!names_pair(e, detection.pairs[k])) continue;
            found = wanted[k] = true;
            compare(e, detection.pairs[k], differences);
        }
        if (!found) differences.push_back(not_found(e, detection));
    }
    for (std::size_t k = 0; k < detection.pairs.size(); ++k) {
        const DetectedPair& p = detection.pairs[k];
        if (!wanted[k]) differences.push_back("found " + p.parts[0] + " - " + p.parts[1] + ", not expected: " + p.why);
    }
    return differences;
}

}  // namespace abut
