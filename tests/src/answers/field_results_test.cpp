// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures show what probes say: fields as they are drawn, between the corners of patches, beside the fields themselves.
#include "src/answers/field_results.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::field_results_test {
namespace {

constexpr const char* steel = R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [)";

/// A thin ring squeezed between two rollers, and a thin bow pulled open: both bend, so that von Mises' stress has a minimum
/// between two sides that are near each other. The bow's cells are long strips.
const std::string bent_ring = std::string(steel) + R"(
    {"name": "ring", "material": "m", "geometry": {"difference": [{"circle": {"center": [0, 0], "radius": 20}, "name": "o"},
        {"circle": {"center": [0, 0], "radius": 19}, "name": "i"}]}},
    {"name": "anvil", "material": "m", "geometry": {"rectangle": {"min": [-6, -30], "max": [6, -20]}}},
    {"name": "stamp", "material": "m", "geometry": {"rectangle": {"min": [-6, 20], "max": [6, 30]}}}],
    "supports": [{"on": "anvil/bottom", "fix": ["x", "y"]},
        {"part": "stamp", "rigid": {"translation": [0, null], "rotation": 0}},
        {"part": "ring", "rigid": {"translation": [0, null], "rotation": 0}}],
    "loads": [{"on": "stamp/top", "traction": [0, -1]}]})";
const std::string pulled_bow = std::string(steel) + R"(
    {"name": "bow", "material": "m", "geometry": {"intersection": [{"half_plane": {"point": [0, 0], "normal": [0, -1]}},
        {"difference": [{"circle": {"center": [0, 0], "radius": 40}, "name": "o"},
            {"circle": {"center": [0, 0], "radius": 39}, "name": "i"}]}]}}],
    "supports": [{"on": {"part": "bow", "box": [[-41, -0.1], [-38, 0.1]]}, "fix": ["x", "y"]}],
    "loads": [{"part": "bow", "body_force": [0.01, -0.02]}]})";

/// What is drawn at a point; nothing where no patch is. Grids that are not turned.
std::optional<Stress> drawn_at(const PartField& field, const Vec2& p) {
    for (const FieldPatch& patch : field.patches) {
        const auto corner = [&](std::size_t i) { return field.samples[static_cast<std::size_t>(patch.corner[i])]; };
        const Vec2 low = corner(0).at, size = corner(2).at - low, u = (p - low).cwiseQuotient(size);
        if (u.minCoeff() < 0 || u.maxCoeff() > 1) continue;
        const std::array<double, 4> weight{(1 - u.x()) * (1 - u.y()), u.x() * (1 - u.y()), u.x() * u.y(), (1 - u.x()) * u.y()};
        Stress s;
        for (std::size_t i = 0; i < 4; ++i) {
            s.xx += weight[i] * corner(i).stress.xx;
            s.yy += weight[i] * corner(i).stress.yy;
            s.xy += weight[i] * corner(i).stress.xy;
            s.zz += weight[i] * corner(i).stress.zz;
        }
        return s;
    }
    return std::nullopt;
}

/// Largest and mean difference in von Mises' stress between what is drawn and what probes on a polar net say, of the part's
/// largest stress; infinite where nothing is drawn.
struct Difference {
    double largest = 0, mean = 0;
};
Difference difference(const std::string& text, double inner, double outer, double from, double to, double wrong = 0) {
    Scene scene = read_scene_text(text, "scene.json");
    for (int i = 0; i < 200; ++i)
        for (int j = 0; j < 9; ++j) {
            const double angle = from + (to - from) * (i + 0.37) / 200, r = inner + (outer - inner) * (0.02 + 0.96 * j / 8);
            scene.output.probes.push_back({scene.parts[0].name, r * Vec2(std::cos(angle), std::sin(angle)), ""});
        }
    const Result result = analyze(scene, {});
    EXPECT_EQ(result.status, "ok") << result.message;
    Difference d;
    for (const ProbeResult& probe : result.probes) {
        const std::optional<Stress> drawn = drawn_at(result.fields[0], probe.at);
        const double value = drawn ? von_mises(*drawn) : std::numeric_limits<double>::infinity();
        const double away = std::abs((1 + wrong) * value - von_mises(probe.stress)) / result.parts[0].max_von_mises.value;
        d.largest = std::max(d.largest, away);
        d.mean += away / static_cast<double>(result.probes.size());
    }
    return d;
}

}  // namespace

TEST(FieldPictures, ShowWhatProbesSayInABentRing) {
    const Difference d = difference(bent_ring, 19, 20, 0, 2 * M_PI);  // 3 pixels a patch, 7 across the ring
    EXPECT_LT(d.largest, 0.04);
    EXPECT_LT(d.mean, 0.005);
}

TEST(FieldPictures, ShowWhatProbesSayInABow) {
    const Difference d = difference(pulled_bow, 39, 40, 0.01, M_PI - 0.01);
    EXPECT_LT(d.largest, 0.02);
    EXPECT_LT(d.mean, 0.002);
}

TEST(FieldPictures, AWrongFieldIsSeen) {
    const Difference d = difference(pulled_bow, 39, 40, 0.01, M_PI - 0.01, 0.1);
    EXPECT_GT(d.largest, 0.02);
    EXPECT_GT(d.mean, 0.002);
}

}  // namespace abut::field_results_test
