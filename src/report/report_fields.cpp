// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the whole model: von Mises stress, and the deformed shape.
#include <algorithm>
#include <cmath>

#include "src/io/number_text.hpp"
#include "src/report/report_field_layer.hpp"
#include "src/report/report_labels.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_svg.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

constexpr double shown_fraction = 0.995;     ///< of the area keeps its colours where the scale is capped
constexpr double peak_ratio = 2.5;           ///< a maximum that many times above the rest hides everything: the scale is capped
constexpr double drawn_displacement = 0.05;  ///< of the model's diagonal: the largest displacement as it is drawn

double displacement_of(const FieldSample& sample) {
    return sample.displacement.norm();
}

/// The largest of the parts' maxima.
struct Peak {
    ValueAt at;
    std::string part;
};
Peak peak(const Result& result, ValueAt PartResult::*quantity) {
    Peak found;
    for (const PartResult& part : result.parts)
        if (part.solved && (part.*quantity).value > found.at.value) found = {part.*quantity, part.name};
    return found;
}

/// The nearest of 1, 2, 5 x 10^k.
double nearest_nice(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    double best = decade;
    for (double m : {2.0, 5.0, 10.0})
        if (std::abs(std::log(m * decade / value)) < std::abs(std::log(best / value))) best = m * decade;
    return best;
}

std::string peak_mark(const Vec2& at, const std::string& words, LabelPlaces& places) {
    places.block(at, 6);
    const Vec2 size(text_pixels(words, 12) + 6, 16);
    const Vec2 middle = places.place(at, size, Vec2(1, -1));
    return line(at + 5 * (middle - at).normalized(), middle, "stroke=\"#000\" stroke-width=\"0.8\"") +
           circle(at, 5, "fill=\"none\" stroke=\"#fff\" stroke-width=\"3\"") +
           circle(at, 5, "fill=\"none\" stroke=\"#000\" stroke-width=\"1.3\"") +
           rectangle(middle - 0.5 * size, size,
                     "rx=\"3\" fill=\"#fff\" fill-opacity=\"0.9\" stroke=\"#000\" stroke-width=\"0.6\"") +
           text(middle + Vec2(0, 4), "middle", words, "class=\"mark\"");
}

LabelPlaces places_in(const View& view) {
    Box2 frame;
    frame.extend(Vec2(2, 2));
    frame.extend(Vec2(view.width - 2, view.height - 32));
    return LabelPlaces(frame);
}

/// The colour scale, capped where a peak would leave one colour for everything else.
ColorBar stress_bar(const Result& result, const ResultUnits& units) {
    const FieldRange range = field_range(result, von_mises_of, shown_fraction, Box2{});
    const double reported = peak(result, &PartResult::max_von_mises).at.value;
    const double largest = reported > 0 ? reported : range.largest;
    ColorBar bar{largest, heading("von Mises stress", units.stress), ""};
    if (!(range.quantile > 0) || largest < peak_ratio * range.quantile) return bar;
    bar.top = range.quantile;
    bar.note = "Scale ends at " + with_unit(bar.top, 3, units.stress) + "; 0.5 % of the area lies above, up to " +
               with_unit(largest, 3, units.stress) + ".";
    return bar;
}

std::string dashed_outlines(const Result& result, const View& view) {
    std::string svg;
    for (const geometry::Part& part : result.geometry)
        svg += path(path_data(part, view), "fill=\"none\" stroke=\"#555\" stroke-width=\"0.8\" stroke-dasharray=\"4 3\"");
    return svg;
}

/// The model, and where its outlines go.
Box2 deformed_box(const Result& result, double exaggeration) {
    Box2 box = model_box(result);
    for (const PartField& field : result.fields)
        for (const auto& loop : field.boundary)
            for (const FieldSample& sample : loop) {
                const Vec2 p = sample.at + exaggeration * sample.displacement;
                if (p.allFinite()) box.extend(p);
            }
    return box;
}

}  // namespace

double drawn_exaggeration(const Result& result) {
    const double largest = peak(result, &PartResult::max_displacement).at.value;
    return largest > 0 ? nearest_nice(drawn_displacement * model_box(result).diagonal() / largest) : 1;
}

std::string stress_figure(const Result& result, const PictureSize& size) {
    const ResultUnits units = result_units(result);
    const View view = model_view(model_box(result), size.width, size.max_height);
    const ColorBar bar = stress_bar(result, units);
    const Peak largest = peak(result, &PartResult::max_von_mises);
    LabelPlaces places = places_in(view);
    std::string svg = open_svg(view.width, view.height, "von Mises stress") + model_axes(view, units.length);
    svg += field_layer(result, view, {von_mises_of, bar.top, 0, Box2{}, "vm"});
    if (largest.at.value > 0)
        svg += peak_mark(view(largest.at.at), "max " + largest_stress_text(*most_stressed(result), 4, units.stress), places);
    return figure(svg + "</svg>\n" + color_bar(bar, half_width), "Von Mises stress", size.width);
}

std::string deformed_figure(const Result& result, const PictureSize& size) {
    const ResultUnits units = result_units(result);
    const Peak largest = peak(result, &PartResult::max_displacement);
    const double exaggeration = drawn_exaggeration(result);
    const View view = model_view(deformed_box(result, exaggeration), size.width, size.max_height);
    const ColorBar bar{largest.at.value, heading("displacement", units.length), ""};
    LabelPlaces places = places_in(view);
    std::string svg = open_svg(view.width, view.height, "deformed shape") + model_axes(view, units.length);
    svg += field_layer(result, view, {displacement_of, bar.top, exaggeration, Box2{}, "def"}) + dashed_outlines(result, view);
    if (largest.at.value > 0) {
        // The displaced place of the maximum: the boundary point next to it knows the displacement's direction.
        const FieldSample* nearest = nullptr;
        for (const PartField& field : result.fields)
            for (const auto& samples : field.boundary)
                for (const FieldSample& s : samples)
                    if (!nearest || (s.at - largest.at.at).norm() < (nearest->at - largest.at.at).norm()) nearest = &s;
        const Vec2 moved = nearest ? Vec2(largest.at.at + exaggeration * nearest->displacement) : largest.at.at;
        svg += peak_mark(view(moved), "max " + with_unit(largest.at.value, 4, units.length), places);
    }
    const std::string caption = largest.at.value > 0 ? "Deformed shape, displacements drawn " + number_text(exaggeration, 3) +
                                                           " times as large; dashed: undeformed"
                                                     : "Deformed shape: nothing moves";
    return figure(svg + "</svg>\n" + color_bar(bar, half_width), caption, size.width);
}

std::string fields_section(const Result& result) {
    if (model_box(result).empty()) return "";
    if (!has_fields(result)) return "<section><h2>Fields</h2>\n<p>No stresses or displacements were computed.</p></section>\n";
    const PictureSize size = picture_size(model_box(result));
    return "<section><h2>Stress and displacement</h2>\n<div class=\"row\">" + stress_figure(result, size) +
           deformed_figure(result, size) + "</div></section>\n";
}

}  // namespace abut::report
