// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/assembly/ring.hpp"

#include <numeric>

namespace abut::solver {

double measure(const PartInput& input) {
    double sum = 0;
    for_all_cells(input, [&](const CellRule& rule) { sum = std::accumulate(rule.weights.begin(), rule.weights.end(), sum); });
    return sum;
}

}  // namespace abut::solver
