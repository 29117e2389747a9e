// SPDX-License-Identifier: GPL-3.0-or-later
// What a support of edges holds, component by component.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/scene/selection.hpp"

namespace abut {

/// One held component of a support: its direction (none: the boundary's normal) and value in the assembly's frame.
struct HeldComponent {
    std::optional<Vec2> direction;
    const Expression* value = nullptr;  ///< null: 0
};

/// The components that a support of edges holds; none for rigid supports and springs.
std::vector<HeldComponent> components_of(const Support& support);

/// Does a support of edges, with these portions, hold the part at the point in this direction (unit)?
bool holds_at(const Scene& scene, std::size_t support, const std::vector<EdgePortion>& portions, int part, const Vec2& p,
              const Vec2& direction);

/// The plan's name for what a support is: of edges that are fixed it is none.
std::string effect_of(const Support& support);

}  // namespace abut
