// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report_marks.hpp"

#include <algorithm>
#include <cmath>

#include "src/io/number_text.hpp"
#include "src/report/report_svg.hpp"

namespace abut::report {

namespace {

constexpr double no_pressure = 1e-6;    ///< of the contact's largest: below it a point counts as open
constexpr double support_spacing = 12;  ///< pixels between signs
constexpr double load_spacing = 15;
constexpr double arrow_length = 30;
constexpr int edge_samples = 32;

/// Keeps marks that are at least the spacing away from those kept before.
template <class Mark>
std::vector<Mark> thinned(const std::vector<Mark>& marks, const View& view, double spacing) {
    std::vector<Mark> kept;
    for (const Mark& mark : marks) {
        const auto near = [&](const Mark& other) { return (view(mark.at) - view(other.at)).norm() < spacing; };
        if (mark.at.allFinite() && std::none_of(kept.begin(), kept.end(), near)) kept.push_back(mark);
    }
    return kept;
}

std::vector<ContactStretch> from_profile(const ContactProfile& p) {
    const double threshold = no_pressure * *std::max_element(p.pressure.begin(), p.pressure.end());
    const auto carries = [&](std::size_t i) { return p.pressure[i] > threshold && p.pressure[i] > 0; };
    const auto at = [&](std::size_t i) { return Vec2(p.x[i], p.y[i]); };
    std::vector<ContactStretch> stretches;
    for (std::size_t i = 0; i + 1 < p.x.size(); ++i) {
        const bool closed = carries(i) || carries(i + 1);
        if (stretches.empty() || stretches.back().closed != closed) stretches.push_back({{at(i)}, closed});
        stretches.back().points.push_back(at(i + 1));
    }
    if (p.x.size() == 1) stretches.push_back({{at(0), at(0)}, carries(0)});
    return stretches;
}

std::vector<ContactStretch> from_names(const Result& result, const ContactResult& contact) {
    std::vector<ContactStretch> stretches;
    for (const geometry::Part& part : result.geometry)
        for (const geometry::Edge& edge : part.edges) {
            const auto& names = contact.edges[0];
            if (std::find(names.begin(), names.end(), part.name + "/" + edge.name) == names.end()) continue;
            ContactStretch stretch{{}, contact.status != "open"};
            for (int i = 0; i <= edge_samples; ++i)
                stretch.points.push_back(geometry::point(edge.curve, static_cast<double>(i) / edge_samples));
            stretches.push_back(std::move(stretch));
        }
    return stretches;
}

/// A piece of hatched ground; neighbours join to a line of it.
std::string ground_sign(const Vec2& at, const Vec2& out) {
    const Vec2 along = geometry::left_of(out);
    std::string svg = line(at - 6 * along, at + 6 * along, "stroke-width=\"2\"");
    for (double shift : {-4.0, 0.0, 4.0}) svg += line(at + shift * along, at + 7 * out + (shift + 4) * along, "");
    return svg;
}

/// A triangle that points at the edge along the held direction, on two rollers.
std::string roller_sign(const Vec2& at, const Vec2& out) {
    const Vec2 along = geometry::left_of(out);
    return polygon({at, at + 7 * out + 4 * along, at + 7 * out - 4 * along}, "fill=\"#fff\"") +
           circle(at + 9 * out + 2.4 * along, 1.5, "fill=\"#fff\"") + circle(at + 9 * out - 2.4 * along, 1.5, "fill=\"#fff\"");
}

/// Held as a whole: nothing of the boundary is held.
std::string pin_sign(const Vec2& at) {
    return circle(at, 6, "fill=\"#fff\"") + line(at - Vec2(6, 0), at + Vec2(6, 0), "") +
           line(at - Vec2(0, 6), at + Vec2(0, 6), "");
}

std::string support_sign(const SupportMark& mark, const Vec2& at) {
    if (!(mark.normal.norm() > 0)) return pin_sign(at);
    const Vec2 out = Vec2(mark.normal.x(), -mark.normal.y()).normalized();  // the picture's y runs down
    if (mark.x == mark.y) return mark.x ? ground_sign(at, out) : roller_sign(at, out);
    const Vec2 axis = mark.x ? Vec2(1, 0) : Vec2(0, 1);
    return roller_sign(at, out.dot(axis) >= 0 ? axis : Vec2(-axis));
}

/// A load that leaves the part pulls at it. Points beside the line of action count too: a mark may lie on a corner.
bool pulls(const Result& result, const LoadMark& mark, double probe) {
    const auto inside = [&](const Vec2& p) {
        return std::any_of(result.geometry.begin(), result.geometry.end(),
                           [&](const auto& part) { return geometry::contains(part, p); });
    };
    const Vec2 step = probe * mark.direction, beside = 0.5 * geometry::left_of(step);
    const auto near = [&](const Vec2& p) { return inside(p) || inside(p + beside) || inside(p - beside); };
    return near(mark.at - step) && !near(mark.at + step);
}

}  // namespace

std::vector<ContactStretch> contact_stretches(const Result& result, const ContactResult& contact) {
    return contact.profile.x.empty() ? from_names(result, contact) : from_profile(contact.profile);
}

Vec2 contact_anchor(const ContactResult& contact, const std::vector<ContactStretch>& stretches) {
    if (contact.max_pressure.value > 0 && contact.max_pressure.at.allFinite()) return contact.max_pressure.at;
    if (stretches.empty()) return contact.max_pressure.at;
    const auto& points = stretches[stretches.size() / 2].points;
    return points[points.size() / 2];
}

std::string contact_lines(const std::vector<ContactStretch>& stretches, const View& view, double width) {
    std::string svg = "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (bool closed : {false, true})
        for (const ContactStretch& stretch : stretches) {
            if (stretch.closed != closed) continue;
            std::vector<Vec2> points;
            for (const Vec2& p : stretch.points) points.push_back(view(p));
            const std::string color = closed ? contact_color : candidate_color;
            svg += polyline(points,
                            "stroke=\"" + color + "\" stroke-width=\"" + coordinate_text(closed ? width : 0.6 * width) + "\"");
        }
    return svg + "</g>\n";
}

std::string number_disc(const std::string& number, const Vec2& anchor, LabelPlaces& places) {
    const double radius = number.size() < 3 ? 9.5 : 12;
    const Vec2 at = places.place(anchor, Vec2::Constant(2 * radius), Vec2(1, -1));
    const std::string color = contact_color;
    return line(anchor, at, "stroke=\"" + color + "\" stroke-width=\"1\"") +
           circle(at, radius, "fill=\"" + color + "\" stroke=\"#fff\" stroke-width=\"1\"") +
           text(at + Vec2(0, 4), "middle", number, "class=\"number\"");
}

std::string support_signs(const std::vector<SupportMark>& marks, const View& view, LabelPlaces& places) {
    std::string svg = "<g stroke=\"" + std::string(support_color) + "\" stroke-width=\"1.1\" fill=\"none\">\n";
    for (const SupportMark& mark : thinned(marks, view, support_spacing)) {
        const Vec2 at = view(mark.at);
        svg += support_sign(mark, at);
        places.block(at + 5 * Vec2(mark.normal.x(), -mark.normal.y()), 6);
    }
    return svg + "</g>\n";
}

std::string load_arrows(const Result& result, const View& view, LabelPlaces& places) {
    std::string svg;
    const double probe = 1e-3 * view.box.diagonal();
    for (const LoadMark& mark : thinned(result.load_marks, view, load_spacing)) {
        if (!(mark.direction.norm() > 0)) continue;
        const Vec2 at = view(mark.at), along = Vec2(mark.direction.x(), -mark.direction.y()).normalized();
        const Vec2 tail = pulls(result, mark, probe) ? at : Vec2(at - arrow_length * along);
        svg += arrow(tail, tail + arrow_length * along, load_color);
        for (double step : {0.0, 10.0, 20.0, 30.0}) places.block(tail + step * along, 4);
    }
    return svg;
}

std::string load_values(const Result& result, const ModelFacts& model, const View& view, LabelPlaces& places) {
    std::string svg;
    if (result.load_marks.empty()) return svg;
    for (const LoadFacts& load : model.loads) {
        if (load.at.empty()) continue;
        // Parts may have been moved since the load was placed: the arrow that is nearest is its own.
        const auto far = [&](const LoadMark& mark) { return (mark.at - load.at.front()).norm(); };
        const LoadMark& mark = *std::min_element(result.load_marks.begin(), result.load_marks.end(),
                                                 [&](const LoadMark& a, const LoadMark& b) { return far(a) < far(b); });
        const std::string words = load_words(load);
        const Vec2 size(text_pixels(words, 12) + 6, 16), middle = places.place(view(mark.at), size, Vec2(1, -1));
        svg += rectangle(middle - 0.5 * size, size,
                         "rx=\"3\" fill=\"#fff\" fill-opacity=\"0.9\" stroke=\"" + std::string(load_color) +
                             "\" stroke-width=\"0.6\"") +
               text(middle + Vec2(0, 4), "middle", words, "class=\"load\"");
    }
    return svg;
}

}  // namespace abut::report
