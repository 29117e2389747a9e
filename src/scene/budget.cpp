// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/budget.hpp"

#include <array>
#include <sstream>

#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

struct BudgetUnit {
    const char* name;
    bool is_time;
    double size;
};
constexpr std::array<BudgetUnit, 5> budget_units{
    {{"s", true, 1}, {"min", true, 60}, {"h", true, 3600}, {"MB", false, 1e6}, {"GB", false, 1e9}}};

/// Adds one bound; false where it is none, or one of its kind is there.
bool add_bound(const std::string& text, Budget& budget) {
    std::istringstream words(text);
    double value = 0;
    std::string unit, rest;
    if (!(words >> value >> unit) || words >> rest || !(value > 0)) return false;
    for (const BudgetUnit& u : budget_units) {
        std::optional<double>& bound = u.is_time ? budget.seconds : budget.bytes;
        if (unit != u.name) continue;
        if (bound) return false;
        bound = value * u.size;
        return true;
    }
    return false;
}

}  // namespace

Budget parse_budget(const std::string& text) {
    Budget budget;
    std::istringstream bounds(text);
    std::string bound;
    bool is_good = true;
    while (is_good && std::getline(bounds, bound, ',')) is_good = add_bound(bound, budget);
    if (is_good && budget.is_given()) return budget;
    throw InputError("", "'" + shortened(bound) + "' is no bound on time or memory",
                     "give a time (s, min, h), a memory (MB, GB) or one of each: 30s, 2GB, or 5min,500MB");
}

}  // namespace abut
