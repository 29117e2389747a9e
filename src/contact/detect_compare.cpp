// SPDX-License-Identifier: GPL-3.0-or-later
// The expectation file of one drawing.
#include <algorithm>

#include "src/contact/detect.hpp"
#include "src/contact/expected_pairs.hpp"
#include "src/io/json_document.hpp"
#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

/// Collects what is wrong with the file, and throws it all at once.
class ExpectationReader {
public:
    explicit ExpectationReader(const std::string& file) : document_(read_json(file)), problems_(document_.problems) {}

    std::vector<ExpectedPair> read() {
        const JsonValue* pairs = find_member(document_.root, "pairs");
        check_keys(document_.root, {"abut", "pairs"});
        if (!pairs || pairs->kind != JsonValue::Kind::array)
            complain(document_.root, "has no list \"pairs\"", "write {\"pairs\": [[\"bracket\", \"pin\"], ...]}");
        std::vector<ExpectedPair> expected;
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

    ExpectedPair pair_of(const JsonValue& item) {
        ExpectedPair expected;
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

}  // namespace

std::vector<std::string> compare_detection(const Detection& detection, const std::string& expectation_file) {
    return count_expected(detection, ExpectationReader(expectation_file).read()).differences;
}

}  // namespace abut
