// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/json_edit.hpp"

#include <gtest/gtest.h>

#include "src/io/json_document.hpp"

namespace abut::json_edit_test {
namespace {

const std::string text =
    "\xEF\xBB\xBF{ // {\"a\": 5}\n  \"a\": [1, \"x, \\\"]}\" /*, 9*/ , {\"b\": -2e3}],\n  \"c\":{\"d/e\" :true },\"f\": []}\n";

TEST(JsonEdit, NothingToEditIsTheSameText) {
    EXPECT_EQ(with_values(text, {}), text);
    EXPECT_EQ(with_values(text, {{"/a/7", "1"}, {"/no/b", "1"}, {"/a/b", "1"}, {"/c/d/f", "1"}}), text);
}

TEST(JsonEdit, OnlyTheValueChanges) {
    EXPECT_EQ(
        with_values(text, {{"/a/2/b", "7"}, {"/c/d~1e", "[1]"}, {"/f", "{}"}}),
        "\xEF\xBB\xBF{ // {\"a\": 5}\n  \"a\": [1, \"x, \\\"]}\" /*, 9*/ , {\"b\": 7}],\n  \"c\":{\"d/e\" :[1] },\"f\": {}}\n");
    EXPECT_EQ(
        with_values(text, {{"/a/1", "\"y\""}, {"/a/0", "2"}}),
        "\xEF\xBB\xBF{ // {\"a\": 5}\n  \"a\": [2, \"y\" /*, 9*/ , {\"b\": -2e3}],\n  \"c\":{\"d/e\" :true },\"f\": []}\n");
    EXPECT_EQ(with_values("[1,2]", {{"", "3"}}), "3");
    EXPECT_EQ(with_values("12", {{"", "3"}}), "3");
}

TEST(JsonEdit, KeysAndItemsAreAddedAtTheEnd) {
    EXPECT_EQ(with_values("{}", {{"/a", "1"}}), "{\"a\": 1}");
    EXPECT_EQ(with_values("{\n  \"a\": {\"b\": 2} // two\n}", {{"/a/c", "3"}, {"/d", "[4]"}}),
              "{\n  \"a\": {\"b\": 2, \"c\": 3}, \"d\": [4] // two\n}");
    EXPECT_EQ(
        with_values(text, {{"/a/-", "5, 6"}, {"/f/-", "7"}, {"/c/d", "8"}, {"/a/0", "0"}}),
        "\xEF\xBB\xBF{ // {\"a\": 5}\n  \"a\": [0, \"x, \\\"]}\" /*, 9*/ , {\"b\": -2e3}, 5, 6],\n  \"c\":{\"d/e\" :true, "
        "\"d\": 8 },\"f\": [7]}\n");
    EXPECT_EQ(with_values("{\"a\": {}}", {{"/a", "{\"b\": 1}"}}), "{\"a\": {\"b\": 1}}");
}

TEST(JsonEdit, WhatIsReadIsWhatWasWritten) {
    const JsonDocument edited = parse_json(with_values(text, {{"/a", "[4]"}, {"/c", "\"z\""}}), "edited");
    EXPECT_EQ(find_pointer(edited.root, "/a/0")->number, 4);
    EXPECT_EQ(find_pointer(edited.root, "/c")->text, "z");
    EXPECT_TRUE(find_pointer(edited.root, "/f")->items.empty());
}

}  // namespace
}  // namespace abut::json_edit_test
