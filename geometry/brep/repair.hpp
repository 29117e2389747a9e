// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "geometry/curves/vec2.hpp"

namespace abut::geometry {

/// Something that was mended in a model, and where.
struct Repair {
    std::string what;
    Vec2 at{0, 0};
    double size = 0;  ///< how far something moved, or how long (wide) what was removed is
    enum class Kind { mended, removed, joined } kind = Kind::mended;  ///< removed: it lay on other things, or had no length
};

}  // namespace abut::geometry
