// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/result_difference.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "geometry/brep/input_error.hpp"
#include "src/io/number_text.hpp"
#include "src/io/text_table.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

using DifferenceJson = nlohmann::ordered_json;

/// Numbers of one result by what they are of and their name, with their absolute errors, in their order.
struct NamedNumber {
    std::string of, quantity;
    double value, error;
};

std::optional<double> number_at(const DifferenceJson& j, const char* pointer) {
    const DifferenceJson::json_pointer at(pointer);
    if (!j.contains(at) || !j.at(at).is_number()) return std::nullopt;
    return j.at(at).get<double>();
}

class NumberList {
public:
    void add(const std::string& of, const std::string& quantity, std::optional<double> value,
             std::optional<double> relative_error = std::nullopt) {
        if (value) numbers.push_back({of, quantity, *value, std::abs(*value) * relative_error.value_or(0)});
    }
    std::vector<NamedNumber> numbers;
};

/// What is nothing but rounding beside the largest of its kind is 0: the force of a support that carries nothing.
void round_off(std::vector<NamedNumber>& numbers) {
    std::map<std::string, double> largest;
    for (const NamedNumber& n : numbers) largest[n.quantity] = std::max(largest[n.quantity], std::abs(n.value));
    for (NamedNumber& n : numbers) n.value = rounded_off(n.value, largest[n.quantity]);
}

double size_of(const DifferenceJson& vector) {
    if (!vector.is_array() || vector.size() != 2 || !vector[0].is_number() || !vector[1].is_number()) return NAN;
    return std::hypot(vector[0].get<double>(), vector[1].get<double>());
}
std::optional<double> size_at(const DifferenceJson& j, const char* key) {
    if (!j.contains(key)) return std::nullopt;
    const double size = size_of(j.at(key));
    return std::isfinite(size) ? std::optional(size) : std::nullopt;
}

/// "a - b", and for further contacts between the same "a - b (2)".
std::string name_of_contact(const DifferenceJson& contact, std::map<std::string, int>& seen) {
    const auto between = contact.at("between").get<std::vector<std::string>>();
    const std::string name = between.at(0) + " - " + between.at(1);
    const int n = ++seen[name];
    return n == 1 ? name : name + " (" + std::to_string(n) + ")";
}

std::vector<NamedNumber> numbers_of(const DifferenceJson& result) {
    NumberList list;
    std::map<std::string, int> seen;
    for (const DifferenceJson& c : result.at("contacts")) {
        const std::string name = name_of_contact(c, seen);
        list.add(name, "force", size_at(c, "force"), number_at(c, "/errors/force"));
        list.add(name, "max pressure", number_at(c, "/max_pressure/value"), number_at(c, "/errors/peak"));
        list.add(name, "contact length", number_at(c, "/contact_length"), number_at(c, "/errors/length"));
        list.add(name, "shear force", number_at(c, "/friction/shear_force"));
    }
    for (const DifferenceJson& p : result.at("parts")) {
        const std::string name = p.at("name").get<std::string>();
        list.add(name, "max von Mises", number_at(p, "/max_von_mises/value"), number_at(p, "/max_von_mises/error"));
        // from where it was drawn: where the loads take it may have been looked at in one of both results only
        const std::optional<double> own = number_at(p, "/max_displacement/value"),
                                    placed = number_at(p, "/placement/max_displacement/value"), whole = placed ? placed : own,
                                    error = number_at(p, "/max_displacement/error");
        list.add(name, "max displacement", whole, own && whole && error && *whole > 0 ? *error * *own / *whole : error);
    }
    for (std::size_t k = 0; k < result.at("reactions").size(); ++k)
        list.add("support " + std::to_string(k + 1), "reaction", size_at(result.at("reactions")[k], "force"));
    for (std::size_t k = 0; k < result.at("probes").size(); ++k)
        list.add("probe " + std::to_string(k + 1), "displacement", size_at(result.at("probes")[k], "displacement"));
    list.add("all", "strain energy", number_at(result, "/strain_energy"));
    round_off(list.numbers);
    return std::move(list.numbers);
}

/// "mm, N"; empty: not given, or of a result that was written before they were.
std::string units_of(const DifferenceJson& result) {
    const DifferenceJson::json_pointer at("/model/units");
    if (!result.contains(at)) return "";
    const auto length = result.at(at).at("length").get<std::string>(), force = result.at(at).at("force").get<std::string>();
    return length.empty() || force.empty() ? length + force : length + ", " + force;
}

struct ReadResult {
    std::string verdict, units;  // "" for units that are not known
    std::vector<NamedNumber> numbers;
};

ReadResult read_result(const std::string& text, const std::string& name) {
    try {
        const DifferenceJson j = DifferenceJson::parse(text);
        return {j.at("verdict").get<std::string>(), units_of(j), numbers_of(j)};
    } catch (const nlohmann::json::exception&) {
        throw InputError(name, "this is no result of abut analyze", "give its folder, or its result.json");
    }
}

std::string shown(const std::optional<double>& value) {
    return value ? number_text(*value, 6) : "-";
}

std::string change_text(const ComparedNumber& n) {
    const std::optional<double> difference = relative_difference(n);
    if (!difference) return "";
    constexpr double rounding = 1e-9;
    if (*difference < rounding) return "same";
    const double change = *n.a != 0 ? (*n.b - *n.a) / std::abs(*n.a) : INFINITY;
    return std::isfinite(change) ? (change > 0 ? "+" : "") + number_text(100 * change, 3) + " %" : "new";
}

}  // namespace

std::optional<double> relative_difference(const ComparedNumber& number) {
    if (!number.a || !number.b) return std::nullopt;
    const double size = std::max(std::abs(*number.a), std::abs(*number.b));
    return size == 0 ? 0 : std::abs(*number.a - *number.b) / size;
}

bool exceeds_errors(const ComparedNumber& number) {
    return number.a && number.b && number.known > 0 && std::abs(*number.a - *number.b) > number.known;
}

ResultDifference compare_results(const std::string& a, const std::string& name_a, const std::string& b,
                                 const std::string& name_b) {
    const ReadResult first = read_result(a, name_a), second = read_result(b, name_b);
    if (!first.units.empty() && !second.units.empty() && first.units != second.units)
        throw InputError(name_b, "this result is in other units, " + second.units + ", than " + name_a + ", " + first.units,
                         "analyse both scenes in the same units");
    ResultDifference difference{first.verdict, second.verdict, {}};
    std::vector<bool> taken(second.numbers.size(), false);
    for (const NamedNumber& n : first.numbers) {
        ComparedNumber compared{n.of, n.quantity, n.value, std::nullopt, 0};
        for (std::size_t k = 0; k < taken.size(); ++k) {
            const NamedNumber& other = second.numbers[k];
            if (taken[k] || other.of != n.of || other.quantity != n.quantity) continue;
            taken[k] = true;
            compared.b = other.value;
            if (n.error > 0 && other.error > 0) compared.known = n.error + other.error;
            break;
        }
        difference.numbers.push_back(std::move(compared));
    }
    for (std::size_t k = 0; k < taken.size(); ++k)
        if (!taken[k])
            difference.numbers.push_back(
                {second.numbers[k].of, second.numbers[k].quantity, std::nullopt, second.numbers[k].value, 0});
    return difference;
}

std::vector<TextRow> difference_rows(const ResultDifference& difference) {
    std::vector<TextRow> rows{{"of", "quantity", "A", "B", "change", ""},
                              {"all", "verdict", difference.verdict_a, difference.verdict_b}};
    for (const ComparedNumber& n : difference.numbers) {
        const std::string remark = !n.a                ? "only in B"
                                   : !n.b              ? "only in A"
                                   : exceeds_errors(n) ? "more than both are known to"
                                                       : "";
        rows.push_back({n.of, n.quantity, shown(n.a), shown(n.b), change_text(n), remark});
    }
    return rows;
}

std::string difference_table(const ResultDifference& difference) {
    return aligned(difference_rows(difference));
}

}  // namespace abut
