// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of the parts as coloured layers of a picture.
#pragma once
#include <functional>
#include <string>

#include "src/report/svg.hpp"
#include "src/results/result.hpp"

namespace abut::report {

/// The value of a field at a sample.
using FieldValue = std::function<double(const FieldSample&)>;

/// How fields are drawn.
struct LayerOptions {
    FieldValue value;
    double top = 1;           ///< the value at the end of the colour scale
    double exaggeration = 0;  ///< samples are drawn at at + exaggeration * displacement
    Box2 window;              ///< patches outside are left out; empty: all are drawn
    std::string id;           ///< prefix of the clip paths' ids, unique in the page
};

/// The von Mises stress of a sample, which pictures of stress show.
double von_mises_of(const FieldSample& sample);

/// The fields of all parts: patches clipped by the (displaced) outlines, grey where there is no field, and the outlines.
std::string field_layer(const Result& result, const View& view, const LayerOptions& options);

/// The largest value among the patches whose middle lies inside its part, and the value below which the fraction of their area
/// lies.
struct FieldRange {
    double largest = 0, quantile = 0;
};
FieldRange field_range(const Result& result, const FieldValue& value, double fraction, const Box2& window);

/// Does any part have a field?
bool has_fields(const Result& result);

}  // namespace abut::report
