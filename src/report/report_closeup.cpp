// SPDX-License-Identifier: GPL-3.0-or-later
// Close-up of one contact: the stress around it, and the pressure as a curve over the first part's edge.
#include <algorithm>
#include <cmath>

#include "geometry/brep/monotone.hpp"
#include "src/io/escape_xml.hpp"
#include "src/report/report_field_layer.hpp"
#include "src/report/report_marks.hpp"
#include "src/report/report_sections.hpp"
#include "src/report/report_svg.hpp"
#include "src/results/result_units.hpp"

namespace abut::report {

namespace {

constexpr double window_factor = 1.9;     ///< window size over the size of the closed contact
constexpr double smallest_window = 1e-3;  ///< of the model: where the contact is a point
constexpr double hair_height = 0.2;       ///< of the window: the largest pressure
constexpr int most_hairs = 45;

/// What is in focus: the closed stretch, or all of an open candidate.
Box2 focus(const std::vector<ContactStretch>& stretches) {
    const bool any = std::any_of(stretches.begin(), stretches.end(), [](const auto& s) { return s.closed; });
    Box2 box;
    for (const ContactStretch& stretch : stretches)
        if (stretch.closed == any)
            for (const Vec2& p : stretch.points) box.extend(p);
    return box;
}

Box2 window_around(const Box2& box, double model) {
    const double size = std::max(window_factor * box.size().maxCoeff(), smallest_window * model);
    const Vec2 half(0.5 * size, 0.42 * size);
    Box2 window;
    window.extend(Vec2(box.center() - half));
    window.extend(Vec2(box.center() + half));
    return window;
}

/// Unit normals at the profile's points, out of the first part.
std::vector<Vec2> normals(const ContactProfile& p, const geometry::Part& first) {
    const std::size_t n = p.x.size();
    const auto boundary = geometry::monotone_pieces(first);
    std::vector<Vec2> found(n, Vec2(0, 1));
    const auto at = [&](std::size_t i) { return Vec2(p.x[i], p.y[i]); };
    double length = 0;
    for (std::size_t i = 0; i + 1 < n; ++i) length += (at(i + 1) - at(i)).norm();
    int outward = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 along = at(std::min(i + 1, n - 1)) - at(i == 0 ? 0 : i - 1);
        if (along.norm() > 0)
            found[i] = geometry::right_of(along).normalized();
        else if (i > 0)
            found[i] = found[i - 1];
        outward += geometry::contains(boundary, at(i) + 1e-3 * length * found[i]) ? -1 : 1;
    }
    if (outward < 0)
        for (Vec2& normal : found) normal = -normal;
    return found;
}

std::string pressure_area(const std::vector<Vec2>& feet, const std::vector<Vec2>& tips) {
    std::vector<Vec2> area = tips;
    area.insert(area.end(), feet.rbegin(), feet.rend());
    return polygon(area, "fill=\"#fff\" fill-opacity=\"0.72\"") +
           polyline(tips, "fill=\"none\" stroke=\"" + std::string(contact_color) +
                              "\" stroke-width=\"1.8\" stroke-linejoin=\"round\"");
}

/// The pressure over the edge, one area for each run of points that carry any (with the neighbours that end it), and hairs in
/// it.
std::string pressure_hairs(const ContactProfile& p, const std::vector<Vec2>& normal, double scale, const View& view) {
    const std::size_t n = p.x.size(), every = std::max<std::size_t>(1, n / most_hairs);
    const auto carries = [&](std::size_t i) { return i < n && p.pressure[i] > 0; };
    std::vector<Vec2> feet, tips;
    std::string areas, hairs;
    for (std::size_t i = 0; i < n; ++i) {
        if (carries(i) || carries(i + 1) || (i > 0 && carries(i - 1))) {
            const Vec2 foot(p.x[i], p.y[i]);
            feet.push_back(view(foot));
            tips.push_back(view(foot + (carries(i) ? p.pressure[i] * scale : 0) * normal[i]));
            if (i % every == 0 && carries(i)) hairs += line(feet.back(), tips.back(), "");
        }
        if (feet.size() > 1 && !carries(i) && !carries(i + 1)) {
            areas += pressure_area(feet, tips);
            feet.clear();
            tips.clear();
        }
    }
    if (feet.size() > 1) areas += pressure_area(feet, tips);
    return areas + "<g stroke=\"" + contact_color + "\" stroke-width=\"0.8\">\n" + hairs + "</g>\n";
}

}  // namespace

std::string contact_closeup(const Result& result, std::size_t contact) {
    const ContactResult& c = result.contacts[contact];
    const auto first = static_cast<std::size_t>(c.part[0]);
    if (c.profile.x.size() < 2 || first >= result.geometry.size()) return "";
    const ResultUnits units = result_units(result);
    const auto stretches = contact_stretches(result, c);
    const Box2 window = window_around(focus(stretches), model_box(result).diagonal());
    const View view = model_view(window, half_width, 422);
    const double largest = field_range(result, von_mises_of, 1, window).largest;
    const std::string id = "close" + std::to_string(contact);

    std::vector<std::vector<Vec2>> frame{
        {window.min, {window.max.x(), window.min.y()}, window.max, {window.min.x(), window.max.y()}}};
    const std::string frame_data = path_data(frame, view);
    std::string svg =
        open_svg(view.width, view.height, "close-up of contact " + contact_number(contact)) + model_axes(view, units.length);
    svg += clip_path(id, frame_data) + "<g clip-path=\"url(#" + id + ")\">\n" + path(frame_data, "fill=\"#f4f4f4\"");
    svg += field_layer(result, view, {von_mises_of, largest, 0, window, id + "f"});
    svg += contact_lines(stretches, view, 3);
    const double peak = *std::max_element(c.profile.pressure.begin(), c.profile.pressure.end());
    if (peak > 0)
        svg +=
            pressure_hairs(c.profile, normals(c.profile, result.geometry[first]), hair_height * window.size().y() / peak, view);
    svg += "</g>\n" + path(frame_data, "fill=\"none\" stroke=\"#999\" stroke-width=\"0.8\"") + "</svg>\n";

    std::string caption = "Close-up";
    if (peak > 0) caption += "; the pressure is drawn over the edge of " + escape_xml(c.parts[0]);
    const std::string bar =
        has_fields(result) ? color_bar({largest, heading("von Mises stress here", units.stress), ""}, half_width) : "";
    return figure(svg + bar, caption, half_width);
}

}  // namespace abut::report
