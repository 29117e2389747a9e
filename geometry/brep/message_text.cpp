// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/message_text.hpp"

#include <cstdio>

namespace abut::geometry {

std::string number_text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", value + 0.0);  // no -0
    return buffer;
}

std::string place_text(const Vec2& p) {
    return "(" + number_text(p.x()) + ", " + number_text(p.y()) + ")";
}

}  // namespace abut::geometry
