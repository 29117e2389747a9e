// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/support_components.hpp"

namespace abut {

std::vector<HeldComponent> components_of(const Support& support) {
    using Kind = Support::Kind;
    if (support.kind == Kind::symmetry) return {HeldComponent{}};
    std::vector<HeldComponent> list;
    if (support.kind != Kind::fix && support.kind != Kind::displacement && support.kind != Kind::points) return list;
    const bool prescribed = support.kind == Kind::displacement;
    if (support.x) list.push_back({Vec2(1, 0), prescribed ? &support.value[0] : nullptr});
    if (support.y) list.push_back({Vec2(0, 1), prescribed ? &support.value[1] : nullptr});
    return list;
}

}  // namespace abut
