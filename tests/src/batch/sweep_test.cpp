// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/sweep.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "geometry/brep/input_error.hpp"
#include "tests/src/io/xml_fault.hpp"

namespace abut::sweep_test {
namespace {

TEST(Sweep, ValuesAreRangesOrLists) {
    const SweptParameter range = parse_swept("F=2000:20000:10");
    EXPECT_EQ(range.name, "F");
    ASSERT_EQ(range.values.size(), 10U);
    EXPECT_EQ(range.values.front(), 2000);
    EXPECT_EQ(range.values[3], 8000);
    EXPECT_EQ(range.values.back(), 20000);
    EXPECT_EQ(parse_swept("c=0.05,-1e-2,0.02").values, (std::vector<double>{-0.01, 0.02, 0.05})) << "ascending";
    EXPECT_EQ(parse_swept("c=1:0:3").values, (std::vector<double>{0, 0.5, 1}));
    EXPECT_EQ(parse_swept("c=1e308:-1e308:3").values, (std::vector<double>{-1e308, 0, 1e308}));
    for (const char* wrong : {"", "F", "=1", "F=", "F=1,", "F=1:2", "F=1:2:1", "F=1:2:2.5", "F=1:1:3", "F=1:2:1e9", "F=1,1",
                              "F=x", "F=nan", "F=1e999", "F=1:2:3:4", "F=1 "})
        EXPECT_THROW(parse_swept(wrong), InputError) << wrong;
}

TEST(Sweep, JobsAreAllCombinationsOnce) {
    const BatchSource source = sweep_jobs({parse_swept("a=1:12:12"), parse_swept("b=5,7"), parse_swept("c=0,1,2")});
    ASSERT_EQ(source.jobs.size(), 72U);
    std::set<std::string> names;
    std::set<std::map<std::string, double>> values;
    for (const BatchJob& job : source.jobs) {
        names.insert(job.name);
        values.insert(job.parameters);
    }
    EXPECT_EQ(names.size(), 72U);
    EXPECT_EQ(values.size(), 72U);
    EXPECT_EQ(source.jobs[0].name, "01_1_1");
    EXPECT_EQ(source.jobs[13].name, "02_2_1") << "the first parameter runs first";
    EXPECT_EQ(source.jobs[13].parameters.at("b"), 7);
    EXPECT_THROW(sweep_jobs({parse_swept("a=1,2"), parse_swept("a=3,4")}), InputError);
    EXPECT_THROW(sweep_jobs({parse_swept("a=0:1:1000"), parse_swept("b=0:1:1000")}), InputError);
}

Sweep made_up() {
    Sweep sweep;
    sweep.scene = "a<b.json";
    sweep.parameters = {parse_swept("F=1,2,3"), parse_swept("R=5,6")};
    sweep.quantities = {{"pin - \"hole\"", "max pressure", "MPa"}, {"pin", "max von Mises stress", "MPa"}};
    for (const BatchJob& job : sweep_jobs(sweep.parameters).jobs) {
        SweepPoint point{job.name, "ok", "", true, job.parameters, {}};
        const double f = job.parameters.at("F");
        if (f == 2 && job.parameters.at("R") == 6) {
            point.status = "failed";
            point.message = "the pin & the hole part";
            point.values.resize(2);
        } else {
            point.values = {SweepValue{100 * f, 2.5}, SweepValue{50 * f, std::nullopt}};
        }
        sweep.points.push_back(std::move(point));
    }
    return sweep;
}

std::size_t count(const std::string& text, const std::string& words) {
    std::size_t n = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++n;
    return n;
}

TEST(Sweep, TheTableHasARowAJob) {
    const std::string begin =
        "job,status,F,R,\"pin - \"\"hole\"\": max pressure [MPa]\",\"pin - \"\"hole\"\": error of max pressure [MPa]\",pin: "
        "max von "
        "Mises stress [MPa],"
        "pin: error of max von Mises stress [MPa]\n"
        "1_1,ok,1,5,100,2.5,50,\n"
        "2_1,ok,2,5,200,2.5,100,\n";
    EXPECT_EQ(sweep_csv(made_up()).substr(0, begin.size()), begin);
    EXPECT_NE(sweep_csv(made_up()).find("2_2,failed,2,6,,,,\n"), std::string::npos);
}

TEST(Sweep, CurvesHaveEveryPointAndMarkThoseThatFailed) {
    const std::string html = sweep_html(made_up());
    const std::size_t body = html.find("<body>");
    EXPECT_EQ(abut_tests::fault_of_xml(html.substr(body, html.find("</html>") - body)), "");
    EXPECT_EQ(count(html, "<circle"), 10U) << "five points of two quantities";
    EXPECT_EQ(count(html, "class=\"failed\""), 4U) << "a cross in each chart";
    EXPECT_EQ(count(html, "<polyline"), 2U) << "of R = 5; a line of R = 6 would go over the gap";
    EXPECT_EQ(count(html, ">R = 6<"), 2U);
    EXPECT_NE(html.find("the pin &amp; the hole part"), std::string::npos);
    EXPECT_NE(html.find("a&lt;b.json"), std::string::npos);
}

TEST(Sweep, LinesAreToldApartByAsManyDigitsAsItTakes) {
    Sweep sweep = made_up();
    sweep.parameters[1] = parse_swept("R=1.00000001,1.00000002");
    for (SweepPoint& p : sweep.points) p.parameters["R"] = p.parameters["R"] == 5 ? 1.00000001 : 1.00000002;
    const std::string html = sweep_html(sweep);
    EXPECT_EQ(count(html, ">R = 1.00000001<"), 2U);
    EXPECT_EQ(count(html, ">R = 1.00000002<"), 2U);
    EXPECT_EQ(count(html, "<polyline"), 2U);
}

TEST(Sweep, JobsThatAreNotThereAreMissing) {
    const Sweep sweep = read_sweep({}, {parse_swept("F=1,2")}, std::filesystem::temp_directory_path() / "abut_no_such_sweep");
    ASSERT_EQ(sweep.points.size(), 2U);
    EXPECT_EQ(sweep.points[0].status, "missing");
    EXPECT_NE(sweep_html(sweep).find("No job has an answer"), std::string::npos);
}

}  // namespace
}  // namespace abut::sweep_test
