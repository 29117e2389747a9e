// SPDX-License-Identifier: GPL-3.0-or-later
// Loose assemblies made up from seeds: discs, boxes and levers in trays, grooves and holes, drawn in mid-air. Each ends at
// rest, with everything in balance and no part in another, or names the motion that nothing stops.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <sstream>

#include "geometry/brep/extent.hpp"
#include "geometry/csg/overlap.hpp"
#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/generated/sound.hpp"

namespace abut::loose_assemblies_test {
namespace {

/// A scene in the making; parts that move come after the first, which is held.
class Loose {
public:
    explicit Loose(std::uint64_t seed) : engine_(seed) {}

    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) / 9007199254740992.0;
    }
    void part(const std::string& name, const std::string& geometry, double turn = 0, Vec2 to = {0, 0}) {
        parts_ += (parts_.empty() ? "" : ", ") + ("{\"name\": \"" + name) + R"(", "material": "m", "geometry": )" + geometry +
                  R"(, "place": {"rotate": )" + number(turn) + R"(, "translate": )" + point(to) + "}}";
    }
    void force(const std::string& part, const Vec2& f) {
        loads_ += (loads_.empty() ? "" : ", ") + ("{\"part\": \"" + part) + R"(", "force": )" + point(f) + "}";
    }
    void hold(const std::string& support) { supports_ += (supports_.empty() ? "" : ", ") + support; }

    std::string text() const {
        return R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}}, "parts": [)" + parts_ + R"(], "supports": [)" +
               supports_ + R"(], "loads": [)" + loads_ + R"(], "accuracy": {"level": "draft"}})";
    }
    static std::string number(double v) {
        std::ostringstream text;
        text.precision(15);
        text << v;
        return text.str();
    }
    static std::string point(const Vec2& p) { return "[" + number(p.x()) + ", " + number(p.y()) + "]"; }
    static std::string disc(double r) { return R"({"circle": {"center": [0, 0], "radius": )" + number(r) + "}}"; }
    static std::string box(double w, double h) {
        return R"({"rectangle": {"min": )" + point({-w / 2, -h / 2}) + R"(, "max": )" + point({w / 2, h / 2}) + "}}";
    }

private:
    std::mt19937_64 engine_;
    std::string parts_, supports_, loads_;
};

/// A tray, open at the top, its floor turned by an angle.
void tray(Loose& s, double half_width, double turn) {
    const double outer = half_width + 20;
    s.part("tray",
           R"({"difference": [{"rectangle": {"min": )" + Loose::point({-outer, -20}) + R"(, "max": )" +
               Loose::point({outer, 50}) + R"(}, "name": "out"}, {"rectangle": {"min": )" + Loose::point({-half_width, 0}) +
               R"(, "max": )" + Loose::point({half_width, 51}) + R"(}, "name": "in"}]})",
           turn);
    s.hold(R"({"on": "tray/out/bottom", "fix": ["x", "y"]})");
}

void discs_in_tray(Loose& s) {
    const int n = 1 + static_cast<int>(s.between(0, 3));
    tray(s, 12 * n + 8, s.between(-15, 15));
    for (int k = 0; k < n; ++k) {
        const std::string name = "disc" + std::to_string(k);
        s.part(name, Loose::disc(s.between(5, 9)), 0, {12.0 * (1 - n) + 24 * k + s.between(-2, 2), s.between(20, 26)});
        s.force(name, {0, -s.between(10, 1000)});
    }
}

void boxes_in_tray(Loose& s) {
    const int n = 1 + static_cast<int>(s.between(0, 2));
    tray(s, 18 * n + 4, s.between(-10, 10));
    for (int k = 0; k < n; ++k) {
        const std::string name = "box" + std::to_string(k);
        s.part(name, Loose::box(s.between(12, 20), s.between(8, 14)), s.between(-35, 35),
               {18.0 * (1 - n) + 36 * k, s.between(22, 28)});
        s.force(name, {0, -s.between(10, 1000)});
    }
}

void disc_in_groove(Loose& s) {
    const double half = s.between(20, 70) * M_PI / 180, depth = 60 / std::tan(half), r = s.between(5, 15);
    s.part(
        "groove",
        "{\"polygon\": [[-60, -30], [60, -30], " + Loose::point({60, depth}) + ", [0, 0], " + Loose::point({-60, depth}) + "]}",
        s.between(-5, 5));
    s.hold(R"({"on": "groove/e0", "fix": ["x", "y"]})");
    s.part("disc", Loose::disc(r), 0, {s.between(-5, 5), 1.3 * r / std::sin(half) + s.between(5, 15)});
    s.force("disc", {0, -100});
}

void pin_in_hole(Loose& s) {
    const double r = s.between(2, 9.8), off = s.between(0, 0.95) * (10 - r), at = s.between(0, 2 * M_PI),
                 to = s.between(0, 2 * M_PI);
    s.part("plate", R"({"difference": [{"rectangle": {"min": [-30, -30], "max": [30, 30]}, "name": "p"},
                                       {"circle": {"center": [0, 0], "radius": 10}, "name": "h"}]})");
    s.hold(R"({"on": "plate/p/bottom", "fix": ["x", "y"]})");
    s.part("pin", Loose::disc(r), 0, off * Vec2(std::cos(at), std::sin(at)));
    s.force("pin", 100 * Vec2(std::cos(to), std::sin(to)));
}

void lever_on_stop(Loose& s) {
    const double length = s.between(60, 100);
    s.part("stop", R"({"rectangle": {"min": [40, -40], "max": [120, -15]}})");
    s.hold(R"({"on": "stop/bottom", "fix": ["x", "y"]})");
    s.part("pin", Loose::disc(5 * s.between(0.97, 0.999)));
    s.hold(R"({"part": "pin", "rigid": {"translation": [0, 0], "rotation": 0}})");
    s.part("lever",
           R"({"difference": [{"union": [{"circle": {"center": [0, 0], "radius": 10}, "name": "eye"},
               {"rectangle": {"min": [0, -3], "max": [)" +
               Loose::number(length) + R"(, 3]}, "name": "arm"}, {"circle": {"center": [)" + Loose::number(length) +
               R"(, 0], "radius": 3}, "name": "tip"}]}, {"circle": {"center": [0, 0], "radius": 5}, "name": "hole"}]})",
           s.between(-4, 30));
    s.force("lever", {s.between(-20, 20), -100});
}

void disc_on_flat(Loose& s) {
    s.part("flat", Loose::box(100, 20), s.between(-1, 1) < 0 ? 0 : s.between(-3, 3));
    s.hold(R"({"on": "flat/bottom", "fix": ["x", "y"]})");
    s.part("disc", Loose::disc(6), 0, {s.between(-20, 20), 19});
    s.force("disc", {s.between(-1, 1), -100});
}

using Kind = std::pair<std::string, void (*)(Loose&)>;
const std::vector<Kind> kinds{{"discs_in_tray", discs_in_tray},   {"boxes_in_tray", boxes_in_tray},
                              {"disc_in_groove", disc_in_groove}, {"pin_in_hole", pin_in_hole},
                              {"lever_on_stop", lever_on_stop},   {"disc_on_flat", disc_on_flat}};

std::string scene_text(const Kind& kind, std::uint64_t seed) {
    Loose scene(seed);
    kind.second(scene);
    return scene.text();
}

/// Of parts where they were analysed, beyond what they deform by.
void expect_no_overlap(const Result& r, const std::string& what) {
    for (std::size_t i = 0; i < r.geometry.size(); ++i)
        for (std::size_t j = i + 1; j < r.geometry.size(); ++j) {
            const double size = std::min(geometry::extent(r.geometry[i]), geometry::extent(r.geometry[j]));
            const double allowed = 1e-4 * size + r.parts[i].max_displacement.value + r.parts[j].max_displacement.value;
            EXPECT_LE(geometry::overlap(r.geometry[i], r.geometry[j], 1e-9 * size).depth, allowed)
                << what << " " << i << " " << j;
        }
}

/// Is one of the parts named?
bool names_a_part(const Scene& scene, const std::string& message) {
    return std::any_of(scene.parts.begin(), scene.parts.end(),
                       [&](const ScenePart& part) { return message.find(part.name) != std::string::npos; });
}

/// How many of them came to rest.
int follow(const Kind& kind, std::uint64_t first, std::uint64_t count) {
    int rests = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const std::string text = scene_text(kind, seed), what = kind.first + " " + std::to_string(seed);
        const Scene scene = read_scene_text(text, "loose.json");
        const test::Answer answer = test::answer_of(scene);
        if (answer.refused) {
            EXPECT_TRUE(names_a_part(scene, answer.message)) << what << ": " << answer.message;
            std::cout << what << ": " << answer.message << "\n";
            continue;
        }
        ++rests;
        for (const std::string& fault : test::faults_of(scene, answer.result)) ADD_FAILURE() << what << ": " << fault;
        expect_no_overlap(answer.result, what);
    }
    return rests;
}

class LooseAssemblies : public testing::TestWithParam<Kind> {};
class LongLooseAssemblies : public testing::TestWithParam<Kind> {};

TEST_P(LooseAssemblies, RestOrNameTheirMotion) {
    follow(GetParam(), 1, 2);
}

/// All but what stands on a flat, of which some slides off.
TEST_P(LongLooseAssemblies, RestOrNameTheirMotion) {
    constexpr int n = 84;
    const int rests = follow(GetParam(), 3, n);
    std::cout << GetParam().first << ": " << rests << " of " << n << " rest\n";
    if (GetParam().first == "disc_on_flat")
        EXPECT_LT(rests, n / 2);
    else
        EXPECT_GT(rests, 0.9 * n);
}

/// Two links of length 60 on three pins of radius 5, the middle one pressed down with 100: a truss whose joints may roll and
/// slide within their holes.
Result linkage(double degrees, double friction, double clearance) {
    const double angle = degrees * M_PI / 180, x = 60 * std::cos(angle), y = 60 * std::sin(angle);
    std::ostringstream text;
    text.precision(17);
    const auto link = [&](const char* name, int level, double turn, double x0, double y0) {
        text << R"({"name": ")" << name << R"(", "material": "m", "level": )" << level << R"(, "place": {"rotate": )" << turn
             << R"(, "translate": [)" << x0 << ", " << y0
             << R"(]}, "geometry": {"difference": [{"slot": {"from": [0, 0], "to": [60, 0], "radius": 10}},
                 {"circle": {"center": [0, 0], "radius": )"
             << 5 + clearance << R"(}}, {"circle": {"center": [60, 0], "radius": )" << 5 + clearance << "}}]}}, ";
    };
    const auto pin = [&](const char* name, const char* level, double x0, double y0) {
        text << R"({"name": ")" << name << R"(", "material": "m", "level": )" << level
             << R"(, "geometry": {"circle": {"center": [)" << x0 << ", " << y0 << R"(], "radius": 5}}})";
    };
    text << R"({"abut": 1, "thickness": 10, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [)";
    link("l1", 1, degrees, 0, 0);
    link("l2", 2, -degrees, x, y);
    pin("A", "1", 0, 0);
    text << ", ";
    pin("B", "[1, 2]", x, y);
    text << ", ";
    pin("C", "2", 2 * x, 0);
    text << R"(], "supports": [{"part": "A", "rigid": {"translation": [0, 0], "rotation": 0}},
        {"part": "C", "rigid": {"translation": [0, 0], "rotation": 0}}], "loads": [{"part": "B", "force": [0, -100]}],
        "contacts": {"friction": )"
         << friction << R"(}, "accuracy": {"level": "draft"}})";
    return analyze(read_scene_text(text.str(), "linkage.json"), {});
}

/// Forces are those of a truss but for what friction turns them by: within the circle of friction at both ends of each link.
TEST(LongLooseLinkages, BearAsTrussesDo) {
    for (const double degrees : {45.0, 20.0, 8.0})
        for (const double friction : {0.02, 0.1})
            for (const double clearance : {0.01, 0.1}) {
                SCOPED_TRACE(std::to_string(degrees) + " degrees, " + std::to_string(friction) + ", " +
                             std::to_string(clearance));
                const Result r = linkage(degrees, friction, clearance);
                ASSERT_EQ(r.status, "ok") << r.message;
                const double angle = degrees * M_PI / 180, turned = std::asin(2 * friction * 5 / 60);
                double least = 1e300, most = 0;
                for (const double a : {angle - turned, angle + turned}) {
                    least = std::min(least, 50 / std::tan(a));
                    most = std::max(most, 50 / std::tan(a));
                }
                for (const ContactResult& c : r.contacts) {
                    if (c.status == "open") continue;
                    EXPECT_NEAR(std::abs(c.force.y()), 50, 50 * turned);
                    EXPECT_GT(std::abs(c.force.x()), 0.98 * least);
                    EXPECT_LT(std::abs(c.force.x()), 1.02 * most);
                }
            }
}

const auto name = [](const auto& kind) { return kind.param.first; };
INSTANTIATE_TEST_SUITE_P(Of, LooseAssemblies, testing::ValuesIn(kinds), name);
INSTANTIATE_TEST_SUITE_P(Of, LongLooseAssemblies, testing::ValuesIn(kinds), name);

}  // namespace
}  // namespace abut::loose_assemblies_test
