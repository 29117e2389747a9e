// SPDX-License-Identifier: GPL-3.0-or-later
// What points to parts and numbers them.
#pragma once
#include <vector>

#include "geometry/sketch/drafting_shapes.hpp"

namespace abut::geometry {

/// Finds balloons, leaders and dots, as find_drafting says, and sets them aside.
class Callouts {
public:
    explicit Callouts(DraftingSearch& found) : found_(found) {}
    /// What is found now; again once the sheet is set aside, which keeps balloons from being clear of all else.
    void find() {
        find_balloons();
        find_leaders();
        find_dots();
    }

private:
    static constexpr std::size_t most_letters = 12;  ///< of a balloon

    std::vector<int> given(const LooseEntities& loose) const;
    std::optional<Arc> circle(const Shape& shape) const { return circle_of(shape, found_.tolerance); }
    bool is_clear(std::size_t shape, double reach) const;
    bool has_text(const Arc& circle, std::size_t most) const;
    bool begins_at_part(const Vec2& p) const;
    bool has_leader(const Arc& circle, bool is_labelled) const;
    bool is_at_annotation(const Vec2& end) const;
    std::vector<Vec2> ends_of(const LooseEntities& loose) const;
    void find_balloons();
    void find_leaders();
    void find_dots();

    DraftingSearch& found_;
    std::vector<Arc> balloons_;
    std::vector<const LooseEntities*> leaders_;
};

}  // namespace abut::geometry
