// SPDX-License-Identifier: GPL-3.0-or-later
// Recursive descent over
//   sum     = product {(+|-) product}
//   product = signed {(*|/) signed}
//   signed  = {+|-} power
//   power   = primary [^ signed]            so -2^2 = -4, 2^-1 = 0.5 and 2^3^2 = 2^9
//   primary = number | name | name ( sum {, sum} ) | ( sum )
// Constant parts are folded while parsing, which is also where 1/0 and log(-1) are found.
#include "src/scene/expression.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/utf8.hpp"

namespace abut {

namespace {

using Function = double (*)(const double* arguments, std::size_t count);

struct FunctionEntry {
    std::string_view name;
    std::size_t least, most;  // number of arguments
    Function function;
};

// Deep enough for anything written by hand; keeps recursion and destruction off the end of the stack.
constexpr int depth_limit = 100;
constexpr int node_limit = 1000;
constexpr std::size_t argument_limit = 8;

double add(const double* a, std::size_t) {
    return a[0] + a[1];
}
double subtract(const double* a, std::size_t) {
    return a[0] - a[1];
}
double multiply(const double* a, std::size_t) {
    return a[0] * a[1];
}
double divide(const double* a, std::size_t) {
    return a[0] / a[1];
}
double power(const double* a, std::size_t) {
    return std::pow(a[0], a[1]);
}
double negate(const double* a, std::size_t) {
    return -a[0];
}

constexpr FunctionEntry functions[] = {
    {"sqrt", 1, 1, [](const double* a, std::size_t) { return std::sqrt(a[0]); }},
    {"exp", 1, 1, [](const double* a, std::size_t) { return std::exp(a[0]); }},
    {"log", 1, 1, [](const double* a, std::size_t) { return std::log(a[0]); }},
    {"sin", 1, 1, [](const double* a, std::size_t) { return std::sin(a[0]); }},
    {"cos", 1, 1, [](const double* a, std::size_t) { return std::cos(a[0]); }},
    {"tan", 1, 1, [](const double* a, std::size_t) { return std::tan(a[0]); }},
    {"asin", 1, 1, [](const double* a, std::size_t) { return std::asin(a[0]); }},
    {"acos", 1, 1, [](const double* a, std::size_t) { return std::acos(a[0]); }},
    {"atan2", 2, 2, [](const double* a, std::size_t) { return std::atan2(a[0], a[1]); }},
    {"min", 2, argument_limit, [](const double* a, std::size_t n) { return *std::min_element(a, a + n); }},
    {"max", 2, argument_limit, [](const double* a, std::size_t n) { return *std::max_element(a, a + n); }},
    {"abs", 1, 1, [](const double* a, std::size_t) { return std::abs(a[0]); }},
};

const FunctionEntry* find_function(std::string_view name) {
    const auto* entry = std::find_if(std::begin(functions), std::end(functions), [&](const auto& f) { return f.name == name; });
    return entry == std::end(functions) ? nullptr : entry;
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace

struct Expression::Node {
    enum class Kind { constant, x, y, function } kind = Kind::constant;
    double value = 0;
    Function function = nullptr;
    std::vector<std::shared_ptr<const Node>> arguments;

    double evaluate(double at_x, double at_y) const {
        switch (kind) {
            case Kind::constant:
                return value;
            case Kind::x:
                return at_x;
            case Kind::y:
                return at_y;
            case Kind::function:
                break;
        }
        double values[argument_limit];
        for (std::size_t i = 0; i < arguments.size(); ++i) values[i] = arguments[i]->evaluate(at_x, at_y);
        return function(values, arguments.size());
    }
};

namespace {

using Node = Expression::Node;
using NodePointer = std::shared_ptr<const Node>;

class Parser {
public:
    Parser(const std::string& text, const std::map<std::string, double>& parameters, bool field)
        : text_(text), parameters_(parameters), field_(field) {}

    NodePointer parse() {
        NodePointer root = sum(0);
        if (!at_end() && !may_be_unit()) fail("expected an operator" + found(), "multiplication is written 2*x, powers x^2");
        return root;
    }

    /// What is left once the expression is read: nothing, or what may be a unit.
    std::string rest() const { return text_.substr(at_); }
    const std::vector<std::string>& names() const { return names_; }

private:
    NodePointer sum(int depth) {
        NodePointer left = product(depth);
        for (;;) {
            const std::size_t at = start_of_next();
            if (take('+'))
                left = apply(add, {left, product(depth)}, at);
            else if (take('-'))
                left = apply(subtract, {left, product(depth)}, at);
            else
                return left;
        }
    }

    NodePointer product(int depth) {
        NodePointer left = signed_power(depth);
        for (;;) {
            const std::size_t at = start_of_next();
            if (take('*'))
                left = apply(multiply, {left, signed_power(depth)}, at);
            else if (take('/'))
                left = apply(divide, {left, signed_power(depth)}, at);
            else
                return left;
        }
    }

    NodePointer signed_power(int depth) {
        check_depth(depth);
        const std::size_t at = start_of_next();
        if (take('-')) return apply(negate, {signed_power(depth + 1)}, at);
        if (take('+')) return signed_power(depth + 1);
        NodePointer base = primary(depth);
        const std::size_t sign = start_of_next();
        if (!take('^')) return base;
        return apply(power, {base, signed_power(depth + 1)}, sign);
    }

    NodePointer primary(int depth) {
        const std::size_t at = start_of_next();
        if (take('(')) {
            NodePointer inner = sum(depth + 1);
            expect(')');
            return inner;
        }
        if (at < text_.size() && (is_digit(text_[at]) || text_[at] == '.')) return number();
        if (at < text_.size() && is_letter(text_[at])) return name(depth);
        fail("expected a number, a name or '('" + found(), "");
    }

    NodePointer number() {
        double value = 0;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error == std::errc::result_out_of_range) fail("this number is too large or too small to be represented", "");
        if (error != std::errc()) fail("expected a number" + found(), "");
        at_ += static_cast<std::size_t>(end - begin);
        return constant(value);
    }

    NodePointer name(int depth) {
        const std::size_t begin = at_;
        while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
        const std::string word = text_.substr(begin, at_ - begin);
        start_of_next();
        if (const FunctionEntry* entry = find_function(word)) return call(*entry, begin, depth);
        if (word == "pi") return constant(std::numbers::pi);
        if (word == "x" || word == "y") return coordinate(word, begin);
        const auto parameter = parameters_.find(word);
        if (parameter != parameters_.end()) {
            names_.push_back(word);
            return constant(parameter->second);
        }
        at_ = begin;
        unknown_name(word);
    }

    /// A name that means nothing in expressions, a sign beyond ASCII (as in °), or 1/ (as in 1/K).
    bool may_be_unit() const {
        const std::string_view rest = std::string_view(text_).substr(at_);
        const bool beyond_ascii = static_cast<unsigned char>(rest[0]) >= 0x80;
        if (!is_letter(rest[0])) return beyond_ascii || rest.starts_with("1/") || rest.starts_with("1 /");
        std::size_t end = 0;
        while (end < rest.size() && (is_letter(rest[end]) || is_digit(rest[end]))) ++end;
        const std::string word(rest.substr(0, end));
        return word != "x" && word != "y" && word != "pi" && !find_function(word) && !parameters_.contains(word);
    }

    NodePointer coordinate(const std::string& word, std::size_t begin) {
        at_ = field_ ? at_ : begin;
        if (!field_)
            fail("'" + word + "' may be used only where a boundary value or a load varies", "use a parameter or a number");
        Node node;
        node.kind = word == "x" ? Node::Kind::x : Node::Kind::y;
        return counted(std::move(node));
    }

    NodePointer call(const FunctionEntry& entry, std::size_t begin, int depth) {
        expect('(');
        std::vector<NodePointer> arguments{sum(depth + 1)};
        while (arguments.size() < argument_limit && take(',')) arguments.push_back(sum(depth + 1));
        expect(')');
        if (arguments.size() < entry.least || arguments.size() > entry.most) {
            at_ = begin;
            const std::string wanted =
                entry.least == entry.most ? std::to_string(entry.least) : "at least " + std::to_string(entry.least);
            fail(std::string(entry.name) + " takes " + wanted + (wanted == "1" ? " argument" : " arguments") + ", not " +
                     std::to_string(arguments.size()),
                 "");
        }
        return apply(entry.function, std::move(arguments), begin);
    }

    NodePointer constant(double value) {
        Node node;
        node.value = value;
        return counted(std::move(node));
    }

    NodePointer apply(Function function, std::vector<NodePointer> arguments, std::size_t at) {
        Node node;
        node.kind = Node::Kind::function;
        node.function = function;
        node.arguments = std::move(arguments);
        const bool constant_arguments = std::all_of(node.arguments.begin(), node.arguments.end(),
                                                    [](const NodePointer& a) { return a->kind == Node::Kind::constant; });
        if (!constant_arguments) return counted(std::move(node));
        const double value = node.evaluate(0, 0);
        at_ = std::isfinite(value) ? at_ : at;
        if (!std::isfinite(value)) fail("the result is not a finite number", "");
        return constant(value);
    }

    NodePointer counted(Node node) {
        if (++n_nodes_ > node_limit) fail("the expression is too long", "split it by means of parameters");
        return std::make_shared<const Node>(std::move(node));
    }

    void check_depth(int depth) {
        if (depth > depth_limit) fail("the expression is nested too deeply", "split it by means of parameters");
    }

    std::size_t start_of_next() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
        return at_;
    }

    bool at_end() { return start_of_next() == text_.size(); }

    bool take(char c) {
        if (at_end() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    void expect(char c) {
        if (!take(c)) fail(std::string("expected '") + c + "'" + found(), "");
    }

    std::string found() {
        if (at_end()) return ", but the expression ends";
        const std::size_t n = std::max<std::size_t>(1, utf8_length(text_, at_));
        return ", found '" + text_.substr(at_, n) + "'";
    }

    [[noreturn]] void unknown_name(const std::string& word) {
        std::vector<std::string> known;
        for (const auto& [parameter, value] : parameters_) known.push_back(parameter);
        known.emplace_back("pi");
        for (const FunctionEntry& entry : functions) known.emplace_back(entry.name);
        if (field_) known.insert(known.end(), {"x", "y"});
        const bool is_unit = at_ > 1 && text_[at_ - 1] == '/';
        fail("unknown name '" + word + "'",
             nearest_name_hint(word, known) + (is_unit ? "; a unit is parted from its number: 12e-6 1/K" : ""));
    }

    [[noreturn]] void fail(const std::string& what, const std::string& hint) {
        throw InputError("", "in the expression '" + shortened(text_) + "', column " + std::to_string(at_ + 1) + ": " + what,
                         hint);
    }

    const std::string& text_;
    const std::map<std::string, double>& parameters_;
    bool field_;
    std::vector<std::string> names_;  // of parameters met
    std::size_t at_ = 0;
    int n_nodes_ = 0;
};

}  // namespace

Expression::Expression(double constant) : constant_(constant) {}

double Expression::operator()(double x, double y) const {
    return root_ ? root_->evaluate(x, y) : constant_;
}

bool Expression::is_constant() const {
    return root_ == nullptr;
}

double Expression::constant() const {
    return constant_;
}

Expression Expression::times(double factor) const {
    if (!root_) return Expression(factor * constant_);
    Node by, product;
    by.value = factor;
    product.kind = Node::Kind::function;
    product.function = multiply;
    product.arguments = {root_, std::make_shared<const Node>(std::move(by))};
    Expression result;
    result.root_ = std::make_shared<const Node>(std::move(product));
    return result;
}

ExpressionWithUnit parse_expression_with_unit(const std::string& text, const std::map<std::string, double>& parameters,
                                              bool field) {
    Parser parser(text, parameters, field);
    const NodePointer root = parser.parse();
    ExpressionWithUnit parsed{Expression(root->value), parser.rest(), parser.names(), false};
    if (root->kind != Node::Kind::constant) parsed.value.root_ = root;
    const std::size_t begin = text.find_first_not_of(" \t+-"), end = text.find_last_not_of(" \t");
    parsed.is_name = parsed.names.size() == 1 && text.compare(begin, end + 1 - begin, parsed.names[0]) == 0;
    return parsed;
}

}  // namespace abut
