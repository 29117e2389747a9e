// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <regex>
#include <set>

#include "src/report/report_contours.hpp"
#include "src/report/report_labels.hpp"
#include "src/report/svg.hpp"
#include "tests/src/report/markup_fault.hpp"
#include "tests/src/results/synthetic_result.hpp"

namespace abut::report_test {
namespace {

using synthetic::bracket;

bool has(const std::string& page, const std::string& words) {
    return page.find(words) != std::string::npos;
}

int count(const std::string& page, const std::string& words) {
    int n = 0;
    for (std::size_t at = page.find(words); at != std::string::npos; at = page.find(words, at + 1)) ++n;
    return n;
}

TEST(ReportFault, FindsWhatIsWrong) {
    EXPECT_EQ(fault("<a><b/></a>"), "");
    EXPECT_NE(fault("<a><b></a>"), "");
    EXPECT_NE(fault("<a>"), "");
    EXPECT_NE(fault("<a x=\"></a>"), "");
    EXPECT_NE(fault("<a id=\"i\"/><b id=\"i\"/>"), "");
    EXPECT_NE(fault("<a clip-path=\"url(#i)\"/>"), "");
}

TEST(Report, IsOneWellFormedFileWithoutTheNetwork) {
    const std::string whole = report_html(bracket()), page = without_scripts(whole);
    EXPECT_EQ(fault(whole), "");
    EXPECT_LT(whole.size(), 1'000'000u);
    EXPECT_EQ(count(whole, "]]>"), 1) << "the end of the script that XML sees";
    EXPECT_EQ(count(whole, "</script>"), 2);
    for (const char* outside : {"src=", "href=", "@import", "@font-face", "url(http"})
        EXPECT_FALSE(has(page, outside)) << outside;
    EXPECT_EQ(count(page, "http"), count(page, "http://www.w3.org/2000/svg"));
    for (const char* nonsense : {"nan", "inf\"", "NaN", "n/a"}) EXPECT_FALSE(has(page, nonsense)) << nonsense;
}

TEST(Report, SaysTheVerdictInWords) {
    EXPECT_TRUE(has(report_html(bracket()), "<p class=\"verdict\">Solved</p>"));
    EXPECT_TRUE(
        has(report_html(bracket()),
            "<p class=\"facts\">1 contact, largest pressure 132.4 MPa on bracket/hole at (0, 40); residual 3e-13; 0.082 s"));
}

TEST(Report, SaysWhatWasAnalysed) {
    EXPECT_FALSE(has(report_html(bracket()), "<h2>Model</h2>"));
    ModelFacts model;
    model.begun = "2026-01-31T12:00:00Z";
    model.files = {{"bracket.json", "2d06800538d394c2"}};
    model.analysis = "plane_stress";
    model.materials = {{"steel", 210000, 0.3, {}, {}, 355.0}, {"rigid", 0, 0, {}, {}, {}, true}};
    model.parts = {{"bracket", "steel", 10}, {"pin", "steel", 1, true}};
    model.loads = {{"pull", "force", {0, -20000}, "N", {"pin"}}, {"", "pressure", {}, "MPa", {"bracket/top"}}};
    model.supports = {{"fix x, y on bracket/bottom", {"bracket/bottom"}}};
    const std::string page = without_scripts(report_html(bracket(), model));
    EXPECT_EQ(fault(page), "");
    for (const char* words : {"bracket.json (2d06800538d394c2)", "2026-01-31T12:00:00Z", "plane stress", "210000", "355",
                              "1 (none was given)", "pull: force (0, -20000) N", "pressure that varies", "mm, N, MPa"})
        EXPECT_TRUE(has(page, words)) << words;
}

TEST(Report, HasEverySection) {
    const std::string page = report_html(bracket());
    for (const char* words : {"Von Mises stress", "drawn 200 times as large", "Pressure and gap", "Close-up", "Reactions",
                              "Equilibrium", "Probes", "Plan of effects", "no temperature load", "von Mises stress [MPa]",
                              "displacement [mm]", "max pressure [MPa]", "fix x, y on bracket/bottom", "aluminium"})
        EXPECT_TRUE(has(page, words)) << words;
}

TEST(Report, UnitsFollowTheScene) {
    EXPECT_TRUE(has(report_html(bracket(1e-3)), "max pressure [Pa]"));
    Result r = bracket();
    r.force_unit = "kgf";
    EXPECT_TRUE(has(report_html(r), "max pressure [kgf/mm²]"));
    r.force_unit = r.length_unit = "";
    const std::string page = without_scripts(report_html(r));
    EXPECT_TRUE(has(page, ">max pressure<"));
    EXPECT_FALSE(has(page, "[]"));
}

TEST(Report, FailureIsRedAndCompleteWithoutFields) {
    Result r = bracket();
    r.status = "failed";
    r.message = "part pin moves <freely>";
    r.fields.clear();
    r.contacts.clear();
    const std::string page = without_scripts(report_html(r));
    EXPECT_EQ(fault(page), "");
    EXPECT_TRUE(has(page, "verdict failed"));
    EXPECT_TRUE(has(page, "Failed: part pin moves &lt;freely&gt;"));
    EXPECT_TRUE(has(page, "No stresses or displacements were computed"));
    EXPECT_FALSE(has(page, "Equilibrium"));
    EXPECT_FALSE(has(page, "No parts touch"));
}

TEST(Report, EscapesNamesEverywhere) {
    Result r = bracket();
    const std::string bad = "<b>&\"bad\"'";
    r.title = bad;
    r.parts[0].name = r.geometry[0].name = r.contacts[0].parts[0] = r.probes[0].part = bad;
    r.parts[0].material = r.contacts[0].interface = r.reactions[0].label = r.effects[0].why = bad;
    r.contacts[0].between[0] = r.contacts[0].edges[0][0] = bad + "/hole";
    r.contacts[0].profile.edge.assign(r.contacts[0].profile.edge.size(), bad + "/hole");
    r.warnings = {bad};
    const std::string page = report_html(r);
    EXPECT_EQ(fault(page), "");
    EXPECT_FALSE(has(page, bad));
    EXPECT_FALSE(has(page, "\"bad\""));
}

TEST(Report, ExtremeResultsStayWellFormed) {
    EXPECT_EQ(fault(report_html(Result{})), "");

    Result open = bracket();
    open.contacts = {synthetic::arc_contact(open, 0, 1, {0, 60}, 20, 4, 5, 0)};
    EXPECT_EQ(fault(report_html(open)), "");
    EXPECT_TRUE(has(report_html(open), "1 contact (open)"));

    Result bare = bracket();
    bare.contacts[0].profile = {};
    EXPECT_EQ(fault(report_html(bare)), "");

    Result nothing = bracket();
    for (PartField& field : nothing.fields)
        for (FieldSample& s : field.samples) s.stress = {};
    for (PartResult& part : nothing.parts) part.max_von_mises = part.max_displacement = {};
    EXPECT_EQ(fault(report_html(nothing)), "");
    EXPECT_TRUE(has(report_html(nothing), "zero everywhere"));

    Result hostile = bracket();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    hostile.fields[0].samples[5].stress.xx = nan;
    hostile.fields[1].boundary[0][3].displacement = {nan, nan};
    hostile.contacts[0].profile.gap[4] = nan;
    EXPECT_EQ(fault(report_html(hostile)), "");
}

TEST(Report, ManyPartsAndContactsAreAllThere) {
    Result r;
    for (int i = 0; i < 12; ++i) {
        const Vec2 c(10.0 * (i % 4), 10.0 * (i / 4));
        synthetic::add_part(r, synthetic::disc("ball" + std::to_string(i), c, 5), "rubber", 12,
                            synthetic::decaying(c, 8, 1, 0.1));
    }
    for (int i = 0; i < 8; ++i)
        r.contacts.push_back(synthetic::arc_contact(r, i, i + 4,
                                                    r.geometry[static_cast<std::size_t>(i)].edges[0].curve.index() == 1
                                                        ? Vec2(10.0 * (i % 4), 10.0 * (i / 4))
                                                        : Vec2(0, 0),
                                                    5, 1.47, 1.67, 1));
    const std::string page = report_html(r);
    EXPECT_EQ(fault(page), "");
    EXPECT_LT(page.size(), 3'000'000u);
    EXPECT_EQ(count(page, "<article>"), 8);
    for (int i = 0; i < 12; ++i) EXPECT_TRUE(has(page, "<b>ball" + std::to_string(i) + "</b>")) << i;
}

TEST(Report, OnlyTheStrongestContactsHavePictures) {
    Result r = bracket();
    const ContactResult contact = r.contacts[0];
    for (int i = 1; i <= 11; ++i) {
        r.contacts.push_back(contact);
        r.contacts.back().max_pressure.value += i % 4;
    }
    const std::string page = without_scripts(report_html(r));
    EXPECT_EQ(fault(page), "");
    EXPECT_EQ(count(page, "<article>"), 8);
    EXPECT_EQ(count(page, "<article class=\"weak\">"), 4);
    EXPECT_EQ(count(page, "Close-up"), 8);
}

TEST(Report, CapsTheScaleOnlyForASingularPeakAndSaysSo) {
    const auto field = [](double peak) {
        return [=](const Vec2& p) {
            FieldSample s;
            s.at = p;
            s.stress.xx = 1 + peak / (1 + 1e4 * p.squaredNorm());
            return s;
        };
    };
    Result smooth, sharp;
    synthetic::add_part(smooth, synthetic::rectangle("p", {0, 0}, {1, 1}), "", 60, field(1));
    synthetic::add_part(sharp, synthetic::rectangle("p", {0, 0}, {1, 1}), "", 60, field(100));
    EXPECT_FALSE(has(report_html(smooth), "Scale ends at"));
    EXPECT_TRUE(has(report_html(sharp), "Scale ends at"));
}

TEST(Report, IsTheSameEveryTime) {
    EXPECT_EQ(report_html(bracket()), report_html(bracket()));
}

// --- contours
// -------------------------------------------------------------------------------------------------------------------

/// Area of all loops of one band's path in square pixels (shoelace over the integer steps), by colour.
std::map<std::string, double> band_areas(const std::string& svg) {
    std::map<std::string, double> areas;
    const std::regex path("fill=\"(#[0-9a-f]{6})\"[^>]* d=\"([^\"]*)\"");
    for (std::sregex_iterator i(svg.begin(), svg.end(), path), none; i != none; ++i) {
        const std::string data = (*i)[2];
        const std::regex number("-?[0-9]+");
        double sum = 0;
        for (std::size_t at = 0; at < data.size();) {
            const std::size_t end = data.find('z', at);
            const std::string loop = data.substr(at, end - at);
            std::vector<long> v;
            for (std::sregex_iterator n(loop.begin(), loop.end(), number); n != none; ++n) v.push_back(std::stol(n->str()));
            long x = 0, y = 0;  // relative to the loop's first point
            for (std::size_t k = 2; k + 1 < v.size(); k += 2) {
                sum += 0.5 * static_cast<double>(x * v[k + 1] - y * v[k]);
                x += v[k];
                y += v[k + 1];
            }
            at = end + 1;
        }
        areas[(*i)[1]] += sum / 100;  // ten steps a pixel
    }
    return areas;
}

std::vector<report::Patch> patches_of(int n, double size, const std::function<double(const Vec2&)>& value) {
    std::vector<report::Patch> patches;
    const double h = size / n;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            report::Patch patch;
            patch.at = {Vec2(i * h, j * h), Vec2((i + 1) * h, j * h), Vec2((i + 1) * h, (j + 1) * h), Vec2(i * h, (j + 1) * h)};
            for (std::size_t c = 0; c < 4; ++c) patch.value[c] = value(patch.at[c] / size);
            patch.middle = value(0.5 * (patch.at[0] + patch.at[2]) / size);
            patches.push_back(patch);
        }
    return patches;
}

TEST(Contours, BandsOfALinearFieldAreEqualStrips) {
    const auto areas = band_areas(report::filled_bands(patches_of(7, 400, [](const Vec2& p) { return p.x(); })));
    ASSERT_EQ(areas.size(), static_cast<std::size_t>(report::n_bands));
    for (const auto& [color, area] : areas)
        EXPECT_NEAR(area, 400.0 * 400 / report::n_bands, 40.0) << color;  // corners: 0.05 pixel on 2 x 400
}

TEST(Contours, BandsCoverThePatchesOnceWhateverTheField) {
    const auto wild = [](const Vec2& p) { return 0.5 + 0.7 * std::sin(9 * p.x()) * std::cos(7 * p.y() + 3 * p.x()); };
    double total = 0;
    for (const auto& [color, area] : band_areas(report::filled_bands(patches_of(30, 300, wild)))) total += area;
    EXPECT_NEAR(total, 300.0 * 300, 1e-6);  // the pieces share their rounded corners: the sum is exact
}

TEST(Contours, OneBandBecomesOneOutline) {
    const std::string svg = report::filled_bands(patches_of(50, 100, [](const Vec2&) { return 0.3; }));
    EXPECT_TRUE(has(svg, "d=\"M0 0l1000 0 0 1000-1000 0z\"")) << svg;
    EXPECT_EQ(count(svg, "<path"), 1);
}

TEST(Contours, OrientationOfPatchesDoesNotMatter) {
    auto patches = patches_of(4, 100, [](const Vec2& p) { return p.x() * p.y(); });
    const auto expected = band_areas(report::filled_bands(patches));
    for (std::size_t i = 0; i < patches.size(); i += 2) {
        std::swap(patches[i].at[1], patches[i].at[3]);
        std::swap(patches[i].value[1], patches[i].value[3]);
    }
    EXPECT_EQ(band_areas(report::filled_bands(patches)), expected);
}

// --- labels
// ---------------------------------------------------------------------------------------------------------------------

Box2 box_around(const Vec2& middle, const Vec2& size) {
    Box2 box;
    box.extend(Vec2(middle - size / 2));
    box.extend(Vec2(middle + size / 2));
    return box;
}

TEST(Labels, CoverNeitherEachOtherNorWhatIsBlocked) {
    Box2 frame;
    frame.extend(Vec2(0, 0));
    frame.extend(Vec2(300, 200));
    report::LabelPlaces places(frame);
    const Box2 blocked = box_around({100, 100}, {40, 40});
    places.block(blocked);
    std::vector<Box2> placed;
    for (int i = 0; i < 8; ++i) placed.push_back(box_around(places.place({100, 100}, {40, 16}, {1, -1}), {40, 16}));
    for (std::size_t i = 0; i < placed.size(); ++i) {
        EXPECT_FALSE(placed[i].overlaps(blocked, 0)) << i;
        EXPECT_TRUE(placed[i].min.x() >= 0 && placed[i].min.y() >= 0 && placed[i].max.x() <= 300 && placed[i].max.y() <= 200)
            << i;
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(placed[i].overlaps(placed[j], 0)) << i << " " << j;
    }
}

TEST(Labels, TakeOnlyFreePlaces) {
    Box2 frame;
    frame.extend(Vec2(0, 0));
    frame.extend(Vec2(100, 100));
    report::LabelPlaces places(frame);
    EXPECT_TRUE(places.take({50, 50}, {20, 10}));
    EXPECT_FALSE(places.take({55, 52}, {20, 10}));
    EXPECT_FALSE(places.take({99, 20}, {20, 10})) << "leaves the frame";
    EXPECT_TRUE(places.take({50, 80}, {20, 10}));
}

}  // namespace
}  // namespace abut::report_test
