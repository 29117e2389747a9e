// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "tests/verification/scene_answers.hpp"

namespace abut::missed_contacts_test {
namespace {

/// A plate on three equal rollers, the middle one lower by `lower`; 100 N on top.
std::string on_rollers(double lower) {
    std::string parts = R"({"name": "plate", "material": "m", "geometry": {"rectangle": {"min": [-45, 0], "max": [45, 20]}}})";
    std::string supports = R"({"part": "plate", "rigid": {"translation": [0, null], "rotation": null}})";
    for (int k = -1; k <= 1; ++k) {
        const std::string name = "r" + std::to_string(k + 1), x = std::to_string(25 * k),
                          y = std::to_string(-10 - (k == 0 ? lower : 0));
        parts += R"(, {"name": ")" + name + R"(", "material": "m", "geometry": {"difference": [{"circle": {"center": [)" + x +
                 ", " + y + R"(], "radius": 10}, "name": "o"}, {"circle": {"center": [)" + x + ", " + y +
                 R"(], "radius": 4}, "name": "i"}]}})";
        supports += R"(, {"on": ")" + name + R"(/i/circle", "fix": ["x", "y"]})";
    }
    return R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [)" + parts + R"(], "supports": [)" +
           supports + R"(], "loads": [{"on": "plate/top", "force": [0, -100]}]})";
}

const ContactResult& contact_of(const Result& r, const std::string& part) {
    for (const ContactResult& c : r.contacts)
        for (int i : c.part)
            if (r.parts[static_cast<std::size_t>(i)].name == part && c.parts[0] != c.parts[1]) return c;
    throw std::runtime_error("no contact of " + part);
}

double force_on(const Result& r, const std::string& part) {
    return contact_of(r, part).force.norm();
}

/// Within twice of what is stated.
void expect_force(const Result& r, const std::string& part, double truth) {
    const ContactResult& c = contact_of(r, part);
    ASSERT_TRUE(c.errors);
    EXPECT_NEAR(c.force.norm(), truth, 2 * c.errors->force * truth) << part;
    EXPECT_LT(c.errors->force, 0.003) << part;
}

TEST(MissedContacts, EveryRollerCarriesItsShareAtEveryAccuracy) {
    // 26.1 N by independent finite elements; the first cells see no contact there, for a mean gap stays open
    for (const char* level : {"draft", "standard", "fine"}) {
        std::string text = on_rollers(0);
        text.insert(text.size() - 1, std::string(R"(, "accuracy": {"level": ")") + level + R"("})");
        const Result r = test::answer(text);
        ASSERT_EQ(r.status, "ok");
        SCOPED_TRACE(level);
        expect_force(r, "r1", 26.12);
        expect_force(r, "r0", 36.94);
    }
}

TEST(MissedContacts, ARollerThatIsTooLowStaysOpenWithoutAWord) {
    const Result r = test::answer(on_rollers(0.01));
    ASSERT_EQ(r.status, "ok");
    EXPECT_EQ(force_on(r, "r1"), 0);
    for (const std::string& warning : r.warnings) EXPECT_EQ(warning.find("overlap"), std::string::npos) << warning;
}

}  // namespace
}  // namespace abut::missed_contacts_test
