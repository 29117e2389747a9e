// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions of the scene format: + - * / ^ ( ), numbers, pi, functions, parameters, and x, y where a field is allowed.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace abut {

/// A parsed expression of x and y. Cheap to copy, safe to evaluate from several threads.
class Expression {
public:
    Expression() = default;  ///< the constant 0
    explicit Expression(double constant);
    double operator()(double x, double y) const;
    /// Does the value depend on neither x nor y?
    bool is_constant() const;
    double constant() const;  ///< value at any point; only if is_constant()
    Expression times(double factor) const;

    struct Node;

private:
    friend struct ExpressionWithUnit parse_expression_with_unit(const std::string&, const std::map<std::string, double>&, bool);
    std::shared_ptr<const Node> root_;
    double constant_ = 0;
};

/// An expression, and what it ends in.
struct ExpressionWithUnit {
    Expression value;  ///< without the unit
    std::string unit;  ///< what follows the expression, where that may be a unit (it is not read here); else empty
    std::vector<std::string> names;  ///< the parameters that it uses
    bool is_name = false;            ///< is it one parameter and nothing else but a sign?
};

/// Reads an expression that may end in a unit: "2*R mm", "1.2e-5 1/K". Names of parameters are no units. `^` is
/// right-associative and binds tighter than unary minus. field: x and y are allowed. Throws InputError (where left empty)
/// naming the column and what was expected.
ExpressionWithUnit parse_expression_with_unit(const std::string& text, const std::map<std::string, double>& parameters,
                                              bool field);

}  // namespace abut
