// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report_field_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/brep/monotone.hpp"
#include "src/report/report_contours.hpp"
#include "src/report/report_svg.hpp"

namespace abut::report {

namespace {

constexpr const char* outline = "fill=\"none\" stroke=\"#222\" stroke-width=\"0.9\"";
constexpr const char* no_field = "fill=\"#e4e4e4\" fill-rule=\"evenodd\" stroke=\"#777\" stroke-width=\"0.9\"";

const FieldSample& corner(const PartField& field, const FieldPatch& patch, std::size_t i) {
    return field.samples[static_cast<std::size_t>(patch.corner[i])];
}

Box2 box_of(const PartField& field, const FieldPatch& patch) {
    Box2 box;
    for (std::size_t i = 0; i < 4; ++i) box.extend(corner(field, patch, i).at);
    return box;
}

bool in_window(const Box2& box, const Box2& window) {
    return window.empty() || box.overlaps(window, 0);
}

/// Components between the corners of a patch, u and v in [0, 1] along its sides.
FieldSample between(const PartField& field, const FieldPatch& patch, double u, double v) {
    const std::array<double, 4> weight{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    FieldSample s{};
    s.at.setZero();
    s.displacement.setZero();
    for (std::size_t i = 0; i < 4; ++i) {
        const FieldSample& c = corner(field, patch, i);
        s.at += weight[i] * c.at;
        s.displacement += weight[i] * c.displacement;
        s.stress.xx += weight[i] * c.stress.xx;
        s.stress.yy += weight[i] * c.stress.yy;
        s.stress.xy += weight[i] * c.stress.xy;
        s.stress.zz += weight[i] * c.stress.zz;
    }
    return s;
}

/// Into how many a patch is divided along a side, so that none is longer than this, in pixels, where a close-up shows it large.
int pieces_of(const Vec2& from, const Vec2& to) {
    constexpr double longest = 8;
    constexpr int most = 32;
    return std::clamp(static_cast<int>(std::ceil((to - from).norm() / longest)), 1, most);
}

std::vector<Patch> patches_of(const PartField& field, const View& view, const LayerOptions& options) {
    std::vector<Patch> patches;
    const auto place = [&](const FieldSample& s) { return view(s.at + options.exaggeration * s.displacement); };
    const auto value = [&](const FieldSample& s) { return options.top > 0 ? options.value(s) / options.top : 0; };
    for (const FieldPatch& patch : field.patches) {
        if (!in_window(box_of(field, patch), options.window)) continue;
        const auto at = [&](std::size_t i) { return place(corner(field, patch, i)); };
        const int n = pieces_of(at(0), at(1)), m = pieces_of(at(0), at(3));
        for (int b = 0; b < m; ++b)
            for (int a = 0; a < n; ++a) {
                Patch drawn{};
                const auto sample = [&](double i, double j) { return between(field, patch, (a + i) / n, (b + j) / m); };
                const bool is_whole = n == 1 && m == 1;  // most are, and have their corners' values as these are
                const std::array<FieldSample, 4> corners =
                    is_whole ? std::array<FieldSample, 4>{corner(field, patch, 0), corner(field, patch, 1),
                                                          corner(field, patch, 2), corner(field, patch, 3)}
                             : std::array<FieldSample, 4>{sample(0, 0), sample(1, 0), sample(1, 1), sample(0, 1)};
                for (std::size_t i = 0; i < 4; ++i) {
                    drawn.at[i] = place(corners[i]);
                    drawn.value[i] = value(corners[i]);
                }
                drawn.middle = value(sample(0.5, 0.5));
                patches.push_back(drawn);
            }
    }
    return patches;
}

/// The exact outline where the part is drawn undeformed, the polylines where it is not.
std::string outline_data(const Result& result, std::size_t part, const View& view, double exaggeration) {
    if (exaggeration == 0) return path_data(result.geometry[part], view);
    std::vector<std::vector<Vec2>> loops;
    for (const auto& loop : result.fields[part].boundary) {
        std::vector<Vec2> points;
        for (const FieldSample& sample : loop) points.push_back(sample.at + exaggeration * sample.displacement);
        loops.push_back(std::move(points));
    }
    return path_data(loops, view);
}

bool has_field(const Result& result, std::size_t part) {
    return part < result.fields.size() && !result.fields[part].patches.empty();
}

}  // namespace

bool has_fields(const Result& result) {
    for (std::size_t i = 0; i < result.geometry.size(); ++i)
        if (has_field(result, i)) return true;
    return false;
}

double von_mises_of(const FieldSample& sample) {
    return von_mises(sample.stress);
}

std::string field_layer(const Result& result, const View& view, const LayerOptions& options) {
    std::string svg;
    for (std::size_t i = 0; i < result.geometry.size(); ++i) {
        if (!in_window(geometry::bounding_box(result.geometry[i]), options.window)) continue;
        if (!has_field(result, i)) {
            svg += path(path_data(result.geometry[i], view), no_field);
            continue;
        }
        const std::string data = outline_data(result, i, view, options.exaggeration);
        const std::string id = options.id + "-" + std::to_string(i);
        svg += clip_path(id, data) + "<g clip-path=\"url(#" + id + ")\">\n" +
               filled_bands(patches_of(result.fields[i], view, options)) + "</g>\n" + path(data, outline);
    }
    return svg;
}

FieldRange field_range(const Result& result, const FieldValue& value, double fraction, const Box2& window) {
    struct Share {
        double value, area;
    };
    std::vector<Share> shares;
    double total = 0;
    for (std::size_t i = 0; i < result.geometry.size(); ++i) {
        if (!has_field(result, i)) continue;
        const auto boundary = geometry::monotone_pieces(result.geometry[i]);
        for (const FieldPatch& patch : result.fields[i].patches) {
            const Box2 box = box_of(result.fields[i], patch);
            if (!in_window(box, window) || !geometry::contains(boundary, box.center())) continue;
            const double middle = value(between(result.fields[i], patch, 0.5, 0.5));
            if (!std::isfinite(middle)) continue;
            shares.push_back({middle, box.size().prod()});
            total += shares.back().area;
        }
    }
    std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.value < b.value; });
    FieldRange range;
    double below = 0;
    for (const Share& share : shares) {
        if (below <= fraction * total) range.quantile = share.value;
        below += share.area;
        range.largest = std::max(range.largest, share.value);
    }
    return range;
}

}  // namespace abut::report
