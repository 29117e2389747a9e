// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions of the scene format: + - * / ^ ( ), numbers, pi, functions, parameters, and x, y where a field is allowed.
#pragma once
#include <map>
#include <memory>
#include <string>

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

    struct Node;

private:
    friend Expression parse_expression(const std::string&, const std::map<std::string, double>&, bool);
    std::shared_ptr<const Node> root_;
    double constant_ = 0;
};

/// Reads an expression. Throws InputError (where left empty) naming the column and what was expected. `^` is right-associative
/// and binds tighter than unary minus. field: x and y are allowed.
Expression parse_expression(const std::string& text, const std::map<std::string, double>& parameters, bool field);

}  // namespace abut
