// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/brep/input_error.hpp"

namespace abut::expression_test {

namespace {

const std::map<std::string, double> parameters{{"R", 20}, {"gap", 0.01}};

Expression parse_expression(const std::string& text, const std::map<std::string, double>& names, bool field) {
    return parse_expression_with_unit(text, names, field).value;
}

double value(const std::string& text) {
    return parse_expression(text, parameters, false).constant();
}

/// The message of the error that the text must cause.
std::string fault(const std::string& text, bool field = false) {
    try {
        parse_expression(text, parameters, field);
    } catch (const InputError& error) { return error.what(); }
    return "no error";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST(Expression, keeps_the_usual_precedence) {
    EXPECT_EQ(value("1+2*3"), 7);
    EXPECT_EQ(value("(1+2)*3"), 9);
    EXPECT_EQ(value("8/4/2"), 1);
    EXPECT_EQ(value("8-4-2"), 2);
    EXPECT_EQ(value("-2^2"), -4);
    EXPECT_EQ(value("2^3^2"), 512);
    EXPECT_EQ(value("2^-1"), 0.5);
    EXPECT_EQ(value("2*-3"), -6);
    EXPECT_EQ(value("--3"), 3);
    EXPECT_EQ(value(" +1.5e-3 "), 1.5e-3);
    EXPECT_EQ(value(".5"), 0.5);
}

TEST(Expression, knows_the_functions) {
    EXPECT_EQ(value("sqrt(2)"), std::sqrt(2.0));
    EXPECT_EQ(value("exp(1)"), std::exp(1.0));
    EXPECT_EQ(value("log(10)"), std::log(10.0));
    EXPECT_EQ(value("sin(1)+cos(2)+tan(3)"), std::sin(1.0) + std::cos(2.0) + std::tan(3.0));
    EXPECT_EQ(value("asin(0.5)"), std::asin(0.5));
    EXPECT_EQ(value("acos(0.5)"), std::acos(0.5));
    EXPECT_EQ(value("atan2(-1, -2)"), std::atan2(-1.0, -2.0));
    EXPECT_EQ(value("min(3, 1, 2)"), 1);
    EXPECT_EQ(value("max(3, 7)"), 7);
    EXPECT_EQ(value("abs(-4)"), 4);
    EXPECT_EQ(value("pi"), std::numbers::pi);
    EXPECT_EQ(value("2*R+gap"), 40.01);
}

TEST(Expression, varies_with_x_and_y_in_fields_only) {
    const Expression e = parse_expression("R*x - y^2 + max(x, y)", parameters, true);
    EXPECT_FALSE(e.is_constant());
    EXPECT_EQ(e(2, 3), 40 - 9 + 3);
    EXPECT_EQ(e(5, -1), 100 - 1 + 5);
    const Expression copy = e;
    EXPECT_EQ(copy(2, 3), e(2, 3));
    EXPECT_TRUE(parse_expression("R^2", parameters, true).is_constant());
    EXPECT_TRUE(contains(fault("2*x"), "column 3: 'x' may be used only where"));
}

TEST(Expression, is_zero_by_default) {
    EXPECT_TRUE(Expression().is_constant());
    EXPECT_EQ(Expression()(1, 2), 0);
    EXPECT_EQ(Expression(3)(1, 2), 3);
}

TEST(Expression, names_the_column_of_a_fault) {
    EXPECT_TRUE(contains(fault(""), "column 1: expected a number, a name or '(', but the expression ends"));
    EXPECT_TRUE(contains(fault("1+"), "column 3: expected a number"));
    EXPECT_TRUE(contains(fault("(1+2"), "column 5: expected ')', but the expression ends"));
    EXPECT_TRUE(contains(fault("1 2"), "column 3: expected an operator, found '2'"));
    EXPECT_TRUE(contains(fault("2R"), "column 2: expected an operator, found 'R'"));
    EXPECT_TRUE(contains(fault("1,5"), "column 2: expected an operator, found ','"));
    EXPECT_TRUE(contains(fault("3*gop"), "column 3: unknown name 'gop'; did you mean 'gap'?"));
    EXPECT_TRUE(contains(fault("sqrt 2"), "column 6: expected '('"));
    EXPECT_TRUE(contains(fault("1+sqrt(1,2)"), "column 3: sqrt takes 1 argument, not 2"));
    EXPECT_TRUE(contains(fault("min(1)"), "min takes at least 2 arguments, not 1"));
}

TEST(Expression, refuses_what_is_not_finite) {
    EXPECT_TRUE(contains(fault("1+1/0"), "column 4: the result is not a finite number"));
    EXPECT_TRUE(contains(fault("log(-1)"), "not a finite number"));
    EXPECT_TRUE(contains(fault("1e999"), "too large"));
    EXPECT_TRUE(contains(fault("10^400"), "not a finite number"));
    EXPECT_TRUE(contains(fault("x+1/0", true), "not a finite number"));
    EXPECT_TRUE(contains(fault("nan"), "unknown name 'nan'"));
    EXPECT_TRUE(contains(fault("inf"), "unknown name 'inf'"));
}

TEST(Expression, bounds_depth_and_length) {
    EXPECT_TRUE(contains(fault(std::string(5000, '(')), "nested too deeply"));
    EXPECT_TRUE(contains(fault(std::string(5000, '-') + "1"), "nested too deeply"));
    std::string sum = "x";
    for (int i = 0; i < 5000; ++i) sum += "+x";
    EXPECT_TRUE(contains(fault(sum, true), "too long"));
    EXPECT_EQ(value(std::string(50, '(') + "1" + std::string(50, ')')), 1);
}

// Whatever is thrown at it, the parser gives a finite constant, a field, or an InputError.
TEST(Expression, survives_random_texts) {
    const std::vector<std::string> tokens{"1", "2.5", "e", "R", "x",    "y",    "(", ")", "+", "-",
                                          "*", "/",   "^", ",", "sqrt", "min(", " ", ".", "#"};
    std::mt19937 random(7);
    int n_parsed = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text;
        for (unsigned n = 1 + static_cast<unsigned>(random()) % 6; n > 0; --n) text += tokens[random() % tokens.size()];
        try {
            const Expression e = parse_expression(text, parameters, true);
            ++n_parsed;
            EXPECT_TRUE(!e.is_constant() || std::isfinite(e.constant())) << text;
        } catch (const InputError& error) { EXPECT_TRUE(contains(error.what(), "column ")) << text; }
    }
    EXPECT_GT(n_parsed, 500);
}

}  // namespace abut::expression_test
