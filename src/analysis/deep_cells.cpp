// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/deep_cells.hpp"

#include <algorithm>

#include "src/base/index.hpp"
#include "src/io/number_text.hpp"

namespace abut {

bool is_too_deep(const SolvedAssembly& solved) {
    return std::any_of(solved.grids.begin(), solved.grids.end(), [](const PartOnGrid& g) { return g.too_fine > 0; });
}

std::string text_of_too_deep(const Scene& scene, const SolvedAssembly& solved) {
    std::string text;
    for (const PartOnGrid& g : solved.grids)
        if (g.too_fine > 0)
            text += (text.empty() ? "a contact or another place is too small beside its part: it asks for cells below what "
                                    "coordinates can tell apart, of "
                                  : ", ") +
                    number_text(g.too_fine, 2) + " in " + scene.parts[at(g.part)].name + " (" +
                    number_text(g.too_fine / g.size, 2) + " of its size)";
    return text + "; compute what lies around that place as an assembly of its own, or put a larger load on it";
}

}  // namespace abut
