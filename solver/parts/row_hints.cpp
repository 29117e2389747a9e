// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/row_hints.hpp"

#include <algorithm>

namespace abut::solver {

RowHints row_hints(const PartInput& input, const std::vector<int>& number) {
    const SplineSpace& space = input.space;
    const int nx = space.x.n_functions();
    RowHints hints;
    if (input.by_cholmod) hints.method = FactorMethod::supernodal;
    hints.reach = std::max(space.x.degree, space.y.degree);
    if (!space.tree) hints.place.reserve(number.size());
    for (std::size_t i = 0; !space.tree && i < number.size(); ++i) {
        const int tensor = space.tensor_of[i / 2];
        if (number[i] != static_cast<int>(hints.place.size())) continue;  // dropped, or had
        hints.place.push_back({tensor % nx, tensor / nx});
    }
    for (int element : input.contact_elements)
        for (int f : extraction(space, element).functions)
            for (int row : {number[static_cast<std::size_t>(2 * f)], number[static_cast<std::size_t>(2 * f) + 1]})
                if (row >= 0) hints.late.push_back(row);
    return hints;
}

RowHints row_hints(const SplineSpace& space) {
    RowHints hints;
    hints.reach = std::max(space.x.degree, space.y.degree);
    const int nx = space.x.n_functions();
    for (int f = 0; !space.tree && f < space.n_functions; ++f) {
        const int tensor = space.tensor_of[static_cast<std::size_t>(f)];
        hints.place.push_back({tensor % nx, tensor / nx});
    }
    return hints;
}

}  // namespace abut::solver
