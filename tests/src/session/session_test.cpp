// SPDX-License-Identifier: GPL-3.0-or-later
// Answers of a session beside whole analyses under the same factors.
#include "src/session/session.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/brep/input_error.hpp"
#include "src/analysis/analysis.hpp"
#include "src/scene/load_cases.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::session_test {
namespace {

Scene scene_with(const std::string& rest) {
    return read_scene_text(R"({"abut": 1, "units": {"length": "mm", "force": "N"},
        "materials": {"steel": {"E": 210000, "nu": 0.3, "expansion": 1.2e-5}}, )" +
                               rest + "}",
                           "session.json");
}

/// A roller between a block that is held and a slab that presses on it, or leaves it: the slab hangs on a spring.
Scene roller(const std::string& more = "") {
    return scene_with(R"("parts": [
        {"name": "base", "material": "steel", "geometry": {"rectangle": {"min": [-20, -20], "max": [20, 0]}}},
        {"name": "roller", "material": "steel", "geometry": {"circle": {"center": [0, 10], "radius": 10}}}],
        "supports": [{"on": "base/bottom", "fix": ["x", "y"]}, {"part": "roller", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"name": "press", "part": "roller", "force": [0, -5000]}, {"name": "lean", "on": "base/right", "pressure": 30},
                  {"part": "roller", "force": [0, -10]}],
        "output": {"probes": [{"part": "roller", "at": [0, 12]}, {"part": "base", "at": [15, -3]}]})" +
                      more);
}

const ContactAnswer& first_closed(const Answer& answer) {
    for (const ContactAnswer& c : answer.contacts)
        if (c.status != "open") return c;
    throw std::runtime_error("no contact is closed");
}

const ContactResult& first_closed(const Result& result) {
    for (const ContactResult& c : result.contacts)
        if (c.status != "open") return c;
    throw std::runtime_error("no contact is closed");
}

Result analyzed(const Scene& scene, const LoadFactors& factors) {
    return analyze(scene_of_case(scene, {"", factors, ""}), {});
}

void expect_same(const Answer& answer, const Result& result, double tolerance, double length_tolerance) {
    ASSERT_EQ(answer.status, "ok") << answer.message;
    ASSERT_EQ(result.status, "ok") << result.message;
    const ContactAnswer& a = first_closed(answer);
    const ContactResult& r = first_closed(result);
    EXPECT_EQ(a.parts, r.parts);
    EXPECT_EQ(a.status, r.status);
    EXPECT_NEAR(a.max_pressure.value, r.max_pressure.value, tolerance * r.max_pressure.value);
    EXPECT_NEAR(a.contact_length, r.contact_length, length_tolerance * r.contact_length);
    EXPECT_NEAR((a.force - r.force).norm(), 0, tolerance * r.force.norm());
    EXPECT_NEAR(a.moment, r.moment, tolerance * (std::abs(r.moment) + r.contact_length * r.force.norm()));
    ASSERT_EQ(answer.probes.size(), result.probes.size());
    double largest = 0;
    for (const ProbeResult& p : result.probes) largest = std::max(largest, p.displacement.norm());
    for (std::size_t k = 0; k < result.probes.size(); ++k)
        EXPECT_NEAR((answer.probes[k].displacement - result.probes[k].displacement).norm(), 0, tolerance * largest) << k;
}

/// Of what an analysis and an answer compute in another order.
constexpr double rounding = 1e-7;

void expect_same(const Answer& answer, const Result& result) {
    expect_same(answer, result, rounding, rounding);
}

TEST(Session, AnswersWhatItWasPreparedUnderAsTheResult) {
    Session session(roller());
    const Result& result = session.result();
    const Answer answer = session.answer();
    expect_same(answer, result);
    EXPECT_TRUE(answer.doubts.empty()) << answer.doubts.front();
    const ContactAnswer& c = first_closed(answer);
    ASSERT_EQ(c.pressure.size(), c.places->x.size());
    // the pressure along the middle curve, here straight but for second order, carries the force
    double force = 0;
    for (std::size_t k = 0; k + 1 < c.pressure.size(); ++k)
        force += 0.5 * (c.pressure[k] + c.pressure[k + 1]) * std::abs(c.places->x[k + 1] - c.places->x[k]);
    EXPECT_NEAR(force, 5010, 0.005 * 5010);
}

/// Hertz' contact grows with the root of the load. Its length is known to a share of the knots' spacing at its ends, a
/// sixteenth of it.
TEST(Session, AnswersOtherFactorsAsAnAnalysisWouldBesideItsErrors) {
    Session session(roller());
    session.prepare();
    for (const auto& [press, lean] : {std::pair{0.8, 1.0}, {1.2, 0.5}, {1, 0}, {0.9, -1}}) {
        session.set_load("press", press);
        session.set_load("lean", lean);
        expect_same(session.answer(), analyzed(session.scene(), session.loads()), 0.02, 0.0625);
    }
    session.set_load("press", 1);
    session.set_load("lean", 1);
    expect_same(session.answer(), session.result());
}

TEST(Session, DoesNotDependOnWhatWasAskedBefore) {
    Session session(roller());
    session.set_load("press", 0.5);
    const double half = first_closed(session.answer()).max_pressure.value;
    for (double press : {2.0, 0.01, -0.001, 0.5}) {
        session.set_load("press", press);
        EXPECT_EQ(session.answer().status, "ok");
    }
    EXPECT_NEAR(first_closed(session.answer()).max_pressure.value, half, rounding * half);
}

TEST(Session, SaysWhereContactGoesBeyondWhatItWasPreparedFor) {
    Session session(roller());
    session.set_load("press", 0.01);
    session.prepare();
    EXPECT_TRUE(session.answer().doubts.empty());
    session.set_load("press", 1);  // ten times as wide
    const Answer wide = session.answer();
    ASSERT_FALSE(wide.doubts.empty());
    EXPECT_NE(wide.doubts[0].find("ends where its grids are coarse"), std::string::npos) << wide.doubts[0];
    // anew, it is known as well as an analysis
    session.prepare();
    EXPECT_TRUE(session.answer().doubts.empty());
}

TEST(Session, ALoadThatLiftsFailsWithTheMotion) {
    Session session(roller());
    session.prepare();
    session.set_load("press", -1);
    const Answer answer = session.answer();
    EXPECT_EQ(answer.status, "failed");
    EXPECT_NE(answer.message.find("roller slides along (0, 1)"), std::string::npos) << answer.message;
    EXPECT_TRUE(session.fields().empty());
    session.set_load("press", 1);
    expect_same(session.answer(), session.result());
}

TEST(Session, FieldsAreThoseOfTheResult) {
    Session session(roller());
    const Result& result = session.result();
    const std::vector<PartField> fields = session.fields();
    ASSERT_EQ(fields.size(), result.fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
        ASSERT_EQ(fields[i].samples.size(), result.fields[i].samples.size());
        ASSERT_FALSE(fields[i].samples.empty());
        double moved = 0, stressed = 0, du = 0, ds = 0;
        for (std::size_t k = 0; k < fields[i].samples.size(); ++k) {
            const FieldSample &a = fields[i].samples[k], &b = result.fields[i].samples[k];
            moved = std::max(moved, b.displacement.norm());
            stressed = std::max(stressed, std::abs(b.stress.yy));
            du = std::max(du, (a.displacement - b.displacement).norm());
            ds = std::max(ds, std::abs(a.stress.yy - b.stress.yy));
        }
        EXPECT_LE(du, rounding * moved);
        EXPECT_LE(ds, rounding * stressed);
    }
}

/// A temperature, and a load on a part that nothing acted on, need other equations: they are prepared by themselves.
TEST(Session, PreparesByItselfWhatItHasNoEquationsOf) {
    const Scene scene = scene_with(R"("parts": [
        {"name": "bar", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [40, 10]}}},
        {"name": "far", "material": "steel", "geometry": {"rectangle": {"min": [100, 0], "max": [140, 10]}}}],
        "supports": [{"on": "bar/left", "fix": ["x", "y"]}, {"on": "far/left", "fix": ["x", "y"]}],
        "loads": [{"name": "pull", "on": "bar/right", "force": [500, 0]}, {"name": "heat", "part": "bar", "temperature": 10},
                  {"name": "other", "on": "far/right", "force": [100, 0]}],
        "output": {"probes": [{"part": "bar", "at": [40, 5]}, {"part": "far", "at": [140, 5]}]}, "accuracy": {"cell_size": 2})");
    Session session(scene);
    session.set_load("other", 0);
    const auto end = [&](std::size_t probe) { return session.answer().probes[probe].displacement.x(); };
    const double both = end(0);
    EXPECT_EQ(end(1), 0);
    session.set_load("heat", 0);
    const double pulled = end(0);
    session.set_load("heat", 2);
    EXPECT_NEAR(end(0), pulled + 2 * (both - pulled), 1e-9 * both);
    EXPECT_GT(both, pulled);
    session.set_load("other", 1);
    EXPECT_GT(end(1), 0);
    session.set_load("pull", 3);
    EXPECT_NEAR(end(0), 3 * pulled + 2 * (both - pulled), 1e-9 * both);
}

TEST(Session, TakesTheFactorsOfACase) {
    Session session(roller(R"(, "cases": [{"name": "light", "loads": {"press": 0.5}}])"));
    session.set_case("light");
    EXPECT_EQ(session.loads(), (LoadFactors{{"lean", 0}, {"press", 0.5}}));
    EXPECT_EQ(session.answer().status, "ok");
    EXPECT_THROW(session.set_case("heavy"), InputError);
}

TEST(Session, RefusesFactorsThatMeanNothing) {
    Session session(roller());
    const auto message = [&](const std::string& name, double factor) -> std::string {
        try {
            session.set_load(name, factor);
        } catch (const InputError& error) { return error.what(); }
        return "";
    };
    EXPECT_NE(message("pres", 1).find("no load has the name 'pres'"), std::string::npos) << message("pres", 1);
    EXPECT_NE(message("pres", 1).find("did you mean 'press'"), std::string::npos);
    EXPECT_NE(message("press", std::numeric_limits<double>::quiet_NaN()).find("is no number"), std::string::npos);
    EXPECT_EQ(session.loads().at("press"), 1);
    Session spun(
        scene_with(R"("parts": [{"name": "bar", "material": "steel", "geometry": {"circle": {"center": [0, 0], "radius": 5}}}],
        "supports": [{"part": "bar", "rigid": {"translation": [0, 0], "rotation": 0}}],
        "loads": [{"name": "speed", "part": "bar", "body_force": [1, 0]}])"));
    EXPECT_NO_THROW(spun.set_load("speed", -1));
}

/// A pin that is drawn beside where it comes to rest: answers are from there.
TEST(Session, AnswersFromWherePartsComeToRest) {
    Session session(scene_with(R"("parts": [
        {"name": "plate", "material": "steel", "geometry": {"difference": [{"rectangle": {"min": [-30, -30], "max": [30, 30]}},
            {"circle": {"center": [0, 0], "radius": 10.5}}]}},
        {"name": "pin", "material": "steel", "geometry": {"circle": {"center": [0, 1.5], "radius": 8}}}],
        "supports": [{"on": {"part": "plate", "facing": [0, -1]}, "fix": ["x", "y"]}],
        "loads": [{"name": "pull", "part": "pin", "force": [0, -3000]}],
        "output": {"probes": [{"part": "pin", "at": [0, 1.5]}]})"));
    const Result& result = session.result();
    ASSERT_NE(result.warnings.end(), std::find_if(result.warnings.begin(), result.warnings.end(), [](const std::string& w) {
                  return w.find("analysed where the loads take it") != std::string::npos;
              }));
    expect_same(session.answer(), result, 1e-5, 1e-5);  // how far the pin still moves is known to rounding of its way
}

}  // namespace
}  // namespace abut::session_test
