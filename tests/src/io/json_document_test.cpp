// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/json_document.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

namespace abut::json_document_test {

namespace {

std::string fault(const std::string& text) {
    try {
        parse_json(text, "f");
    } catch (const InputError& error) { return error.what(); }
    return "no error";
}

const std::string sample =
    "// a scene\n{\"a\": [1, -2.5e3, true, null],\n \"b/~\": {\"c\": \"d\\n\\u00e9\\ud83d\\ude00\"} /* end\n */, \"e\": 0}\n";

}  // namespace

TEST(JsonDocument, keeps_values_lines_and_pointers) {
    const JsonDocument document = parse_json(sample, "f");
    const JsonValue* list = find_member(document.root, "a");
    ASSERT_NE(list, nullptr);
    ASSERT_EQ(list->items.size(), 4u);
    EXPECT_EQ(list->items[1].number, -2500);
    EXPECT_EQ(list->items[1].pointer, "/a/1");
    EXPECT_EQ(list->items[1].line, 2);
    EXPECT_TRUE(list->items[2].boolean);
    EXPECT_EQ(list->items[3].kind, JsonValue::Kind::null);
    const JsonValue* text = find_pointer(document.root, "/b~1~0/c");
    ASSERT_NE(text, nullptr);
    EXPECT_EQ(text->text, "d\n\xC3\xA9\xF0\x9F\x98\x80");
    EXPECT_EQ(place_of("f", *text), "f:3 /b~1~0/c");
    EXPECT_EQ(find_member(document.root, "e")->line, 4);
    EXPECT_EQ(find_pointer(document.root, "/b~1~0/x"), nullptr);
    EXPECT_EQ(find_pointer(document.root, ""), &document.root);
}

TEST(JsonDocument, reports_duplicate_keys_and_keeps_the_first) {
    const JsonDocument document = parse_json("{\"a\": 1,\n\"b\": 2,\n\"a\": 3}", "f");
    ASSERT_EQ(document.problems.size(), 1u);
    EXPECT_EQ(document.problems[0].where, "f:3 /a");
    EXPECT_EQ(document.problems[0].what, "the key 'a' is given twice");
    EXPECT_EQ(find_member(document.root, "a")->number, 1);
}

TEST(JsonDocument, says_what_was_expected_and_where) {
    EXPECT_EQ(fault(""), "f:1:1: expected a value, but the file ends");
    EXPECT_EQ(fault("{\"a\": 1\n \"b\": 2}"), "f:2:2: expected ',' or '}' after a value, found '\"'");
    EXPECT_EQ(fault("{\"a\": 1,}"), "f:1:9: expected a key in double quotes, found '}'; remove the comma before it");
    EXPECT_EQ(fault("{a: 1}"), "f:1:2: expected a key in double quotes, found 'a'");
    EXPECT_EQ(fault("{\"a\" 1}"), "f:1:6: expected ':' after the key \"a\", found '1'");
    EXPECT_EQ(fault("[1, 2"), "f:1:6: expected ',' or ']' after a value, but the file ends");
    EXPECT_EQ(fault("[1,\n]"), "f:2:1: expected a value, found ']'; remove the comma before it");
    EXPECT_EQ(fault("{} x"), "f:1:4: expected the end of the file, found 'x'");
    EXPECT_EQ(fault("[1.]"), "f:1:4: expected a digit after the decimal point, found ']'");
    EXPECT_EQ(fault("[\"a]"), "f:1:2: this text has no closing double quote on its line");
    EXPECT_EQ(fault("[\"\\q\"]").substr(0, 14), "f:1:4: expecte");
    EXPECT_EQ(fault("/* \n"), "f:1:1: this comment has no end; close it with */");
    EXPECT_EQ(fault("[NaN]").substr(0, 37), "f:1:2: expected a value, found 'NaN';");
    EXPECT_EQ(fault("[1e999]"), "f:1:2: this number is too large or too small to be represented");
    EXPECT_EQ(fault("[\"\xff\"]").substr(0, 29), "f:1:3: this is not UTF-8 text");
    EXPECT_NE(fault(std::string(100000, '[')).find("nested too deeply"), std::string::npos);
}

TEST(JsonDocument, names_files_that_cannot_be_read) {
    EXPECT_THROW(read_json("/nowhere/scene.json"), InputError);
    EXPECT_THROW(read_json("/"), InputError);
}

// Another parser accepts and rejects the same texts (but for numbers that underflow, which it takes for 0).
TEST(JsonDocument, agrees_with_an_independent_parser_on_mutated_texts) {
    std::mt19937 random(3);
    const std::string characters = "{}[]\",:/*\\ \n0123e.-truefalsn\xC3\xA9\x01";
    int n_good = 0, n_bad = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = sample;
        for (unsigned n = 1 + static_cast<unsigned>(random()) % 2; n > 0; --n) {
            const std::size_t at = random() % text.size();
            const char c = characters[random() % characters.size()];
            switch (random() % 3) {
                case 0:
                    text[at] = c;
                    break;
                case 1:
                    text.erase(at, 1 + random() % 3);
                    break;
                default:
                    text.insert(at, 1, c);
            }
        }
        if (text.find("e-") != std::string::npos) continue;
        const bool good = fault(text) == "no error";
        EXPECT_EQ(good, nlohmann::json::accept(text, true)) << text << "\n" << fault(text);
        ++(good ? n_good : n_bad);
    }
    EXPECT_GT(n_good, 1000);
    EXPECT_GT(n_bad, 1000);
}

}  // namespace abut::json_document_test
