// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/result_difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/brep/input_error.hpp"
#include "src/results/model_facts.hpp"
#include "src/results/result.hpp"

namespace abut::result_difference_test {
namespace {

/// Two contacts between the same edges, one between others, and two parts.
Result some_result() {
    Result r;
    for (const char* name : {"a", "b"}) {
        PartResult p;
        p.name = name;
        p.max_von_mises = {100, {0, 0}};
        p.max_von_mises_error = 0.01;
        p.max_displacement = {0.5, {0, 0}};
        r.parts.push_back(p);
    }
    for (const auto& [first, second] : {std::pair{"a/x", "b/y"}, {"a/x", "b/y"}, {"a/z", "b/z"}}) {
        ContactResult c;
        c.parts = {"a", "b"};
        c.between = {first, second};
        c.status = "closed";
        c.force = {3, 4};
        c.max_pressure = {20, {1, 2}};
        c.errors = ContactErrors{0.01, 0.02, 0.001, 0.03, false};
        r.contacts.push_back(c);
    }
    return r;
}

const ComparedNumber& number(const ResultDifference& d, const std::string& of, const std::string& quantity) {
    const auto found =
        std::find_if(d.numbers.begin(), d.numbers.end(), [&](const auto& n) { return n.of == of && n.quantity == quantity; });
    if (found == d.numbers.end()) throw std::runtime_error("no " + quantity + " of " + of);
    return *found;
}

ResultDifference compared(const Result& a, const Result& b) {
    return compare_results(result_json(a), "a.json", result_json(b), "b.json");
}

TEST(ResultDifference, AResultIsTheSameAsItself) {
    const ResultDifference d = compared(some_result(), some_result());
    EXPECT_GE(d.numbers.size(), 13U);
    for (const ComparedNumber& n : d.numbers) {
        EXPECT_EQ(relative_difference(n), 0) << n.of << " " << n.quantity;
        EXPECT_FALSE(exceeds_errors(n));
    }
    EXPECT_EQ(number(d, "a/x - b/y (2)", "force").a, 5);
}

TEST(ResultDifference, RoundingIsNone) {
    Result a = some_result();
    a.reactions.resize(2);
    a.reactions[0].force = {0, 2000};
    a.reactions[1].force = {1e-14, 0};
    Result b = a;
    b.reactions[1].force = {3e-14, 0};
    EXPECT_EQ(relative_difference(number(compared(a, b), "support 2", "reaction")), 0);
    b.reactions[1].force = {3e-3, 0};
    EXPECT_EQ(relative_difference(number(compared(a, b), "support 2", "reaction")), 1);
}

TEST(ResultDifference, WhatDiffersIsTold) {
    Result other = some_result();
    other.contacts[1].max_pressure.value = 21;     // both known to 2 %
    other.contacts[2].max_pressure.value = 20.5;   // 0.5 of 0.81
    other.parts[0].max_displacement.value = 0.25;  // known to nobody knows what
    const ResultDifference d = compared(some_result(), other);
    const ComparedNumber &far = number(d, "a/x - b/y (2)", "max pressure"), &near = number(d, "a/z - b/z", "max pressure");
    EXPECT_NEAR(*relative_difference(far), 1.0 / 21, 1e-12);
    EXPECT_TRUE(exceeds_errors(far));
    EXPECT_NEAR(far.known, 0.82, 1e-12);
    EXPECT_FALSE(exceeds_errors(near));
    EXPECT_FALSE(exceeds_errors(number(d, "a", "max displacement")));
    EXPECT_EQ(relative_difference(number(d, "a", "max displacement")), 0.5);
    const std::string table = difference_table(d);
    EXPECT_NE(table.find("+5 %"), std::string::npos) << table;
    EXPECT_NE(table.find("more than both are known to"), std::string::npos);
}

TEST(ResultDifference, WhatOnlyOneHasIsTold) {
    Result other = some_result();
    other.contacts.pop_back();
    other.parts[1].name = "c";
    const ResultDifference d = compared(some_result(), other);
    EXPECT_FALSE(number(d, "a/z - b/z", "force").b);
    EXPECT_FALSE(number(d, "b", "max von Mises").b);
    EXPECT_FALSE(number(d, "c", "max von Mises").a);
    EXPECT_FALSE(relative_difference(number(d, "c", "max von Mises")));
    const std::string table = difference_table(d);
    EXPECT_NE(table.find("only in A"), std::string::npos);
    EXPECT_NE(table.find("only in B"), std::string::npos);
}

TEST(ResultDifference, OtherUnitsAreRefused) {
    ModelFacts mm, m;
    mm.analysis = m.analysis = "plane_stress";
    mm.length_unit = "mm";
    m.length_unit = "m";
    const auto text = [](const ModelFacts& model) { return result_json(some_result(), model); };
    EXPECT_NO_THROW(compare_results(text(mm), "a.json", text(mm), "b.json"));
    EXPECT_NO_THROW(compare_results(text(mm), "a.json", result_json(some_result()), "b.json"));
    try {
        compare_results(text(mm), "a.json", text(m), "b.json");
        FAIL() << "compared";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("in other units, m, than a.json, mm"), std::string::npos) << error.what();
    }
}

TEST(ResultDifference, OtherFilesAreRefused) {
    for (const std::string text : {"", "{}", "[1]", R"({"verdict": 5})"})
        EXPECT_THROW(compare_results(result_json(some_result()), "a.json", text, "b.json"), InputError) << text;
}

}  // namespace
}  // namespace abut::result_difference_test
