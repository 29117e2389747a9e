// SPDX-License-Identifier: GPL-3.0-or-later
// Where labels fit into a picture without hiding lines or each other. All in picture coordinates (pixels, y down).
#pragma once
#include <string>
#include <vector>

#include "geometry/curves/curve.hpp"
#include "src/report/svg.hpp"

namespace abut {

/// The free room of a picture.
class LabelPlacement {
public:
    /// Labels are to stay inside this area.
    explicit LabelPlacement(const Box2& area);

    /// Marks a curve that labels are not to cover.
    void add_line(const geometry::Curve& curve, const View& view);
    /// Is the box inside the area and clear of labels? lines: and of lines?
    bool is_free(const Box2& box, bool lines) const;
    /// Keeps later labels off the box.
    void take(const Box2& box) { taken_.push_back(box); }

private:
    bool touches_line(const Box2& box) const;

    static constexpr double cell_ = 3;  ///< pixels: finer than the height of any label
    Box2 area_;
    int nx_ = 0, ny_ = 0;
    std::vector<bool> has_line_;  ///< nx_ x ny_ cells of the area
    std::vector<Box2> taken_;
};

/// The box of a text of one line that is centred on a point.
Box2 text_box(const std::string& text, double font_size, const Vec2& middle);

}  // namespace abut
