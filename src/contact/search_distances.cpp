// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/search_distances.hpp"

#include <algorithm>

#include "geometry/brep/extent.hpp"
#include "src/base/index.hpp"

namespace abut {

double touching_length(const geometry::Part& first, const geometry::Part& second) {
    return touching_fraction * std::min(geometry::extent(first), geometry::extent(second));
}

SearchDistances::SearchDistances(const Scene& scene) : given_(scene.contacts.search_distance) {
    for (const ScenePart& part : scene.parts) {
        boxes_.push_back(bounding_box(part.part));
        extents_.push_back(geometry::extent(part.part));
        roundings_.push_back(part.rounding);
        levels_.push_back(part.level);
    }
}

double SearchDistances::size(int first, int second) const {
    return std::min(extents_[at(first)], extents_[at(second)]);
}

double SearchDistances::precision(int first, int second) const {
    const double extent = size(first, second), written = roundings_[at(first)] + roundings_[at(second)];
    return std::max(precision_fraction * extent, std::min(written, written_precision_fraction * extent));
}

double SearchDistances::searched(int first, int second, double factor) const {
    return given_.value_or(factor * first_search_fraction * size(first, second));
}

double SearchDistances::shown(int first, int second) const {
    return given_.value_or(shown_fraction * size(first, second));
}

bool SearchDistances::within(int first, int second, double distance) const {
    return have_common_level(levels_[at(first)], levels_[at(second)]) &&
           boxes_[at(first)].overlaps(boxes_[at(second)], distance);
}

}  // namespace abut
