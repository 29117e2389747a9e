// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/label_placement.hpp"

#include <algorithm>
#include <cmath>

#include "src/io/utf8.hpp"
#include "src/results/result_units.hpp"

namespace abut {

LabelPlacement::LabelPlacement(const Box2& area)
    : area_(area),
      nx_(static_cast<int>(area.size().x() / cell_) + 1),
      ny_(static_cast<int>(area.size().y() / cell_) + 1),
      has_line_(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), false) {}

void LabelPlacement::add_line(const geometry::Curve& curve, const View& view) {
    const int n = static_cast<int>(std::ceil(geometry::length(curve) * view.scale / (cell_ / 2))) + 1;
    for (int i = 0; i <= n; ++i) {
        const Vec2 p = (view(geometry::point(curve, static_cast<double>(i) / n)) - area_.min) / cell_;
        const int x = static_cast<int>(std::floor(p.x())), y = static_cast<int>(std::floor(p.y()));
        if (x >= 0 && y >= 0 && x < nx_ && y < ny_) has_line_[static_cast<std::size_t>(y * nx_ + x)] = true;
    }
}

bool LabelPlacement::touches_line(const Box2& box) const {
    const Vec2 lo = (box.min - area_.min) / cell_, hi = (box.max - area_.min) / cell_;
    for (int y = std::max(0, static_cast<int>(lo.y())); y <= std::min(ny_ - 1, static_cast<int>(hi.y())); ++y)
        for (int x = std::max(0, static_cast<int>(lo.x())); x <= std::min(nx_ - 1, static_cast<int>(hi.x())); ++x)
            if (has_line_[static_cast<std::size_t>(y * nx_ + x)]) return true;
    return false;
}

bool LabelPlacement::is_free(const Box2& box, bool lines) const {
    const bool is_inside = (box.min.array() >= area_.min.array()).all() && (box.max.array() <= area_.max.array()).all();
    if (!is_inside || (lines && touches_line(box))) return false;
    return std::none_of(taken_.begin(), taken_.end(), [&](const Box2& other) { return box.overlaps(other, 1); });
}

Box2 text_box(const std::string& text, double font_size, const Vec2& middle) {
    constexpr double character_width = 0.58;  // of the font size: a sans-serif's mean, digits and lower case
    const Vec2 half(0.5 * character_width * font_size * static_cast<double>(text_width(text)), 0.5 * font_size);
    Box2 box;
    box.extend(Vec2(middle - half));
    box.extend(Vec2(middle + half));
    return box;
}

}  // namespace abut
