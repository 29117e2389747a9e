// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "src/study/study_prices.hpp"
#include "tests/src/report/markup_fault.hpp"
#include "tests/src/study/synthetic_study.hpp"

namespace abut::study_files_test {
namespace {

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

/// Fields of a line of CSV; quotes are doubled inside quoted fields.
std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> list{""};
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
            list.back() += line[++i];
        else if (line[i] == '"')
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            list.emplace_back();
        else
            list.back() += line[i];
    }
    return list;
}

TEST(StudyFiles, ThePageHoldsTogether) {
    Study study = synthetic::study(1.25);
    EXPECT_EQ(fault(study_html(study)), "");
    for (StudyMeasure& m : study.measures) m.held = true;
    EXPECT_EQ(fault(study_html(study)), "");
    study.runs.clear();
    EXPECT_EQ(fault(study_html(study)), "");
    EXPECT_NE(fault(study_html(synthetic::study(1)) + "<b>"), "");  // the check can fail
}

TEST(StudyFiles, ThePageShowsWhatFailedAndWhatWasLeftOut) {
    const std::string page = study_html(synthetic::study(1));
    for (const char* words : {"A &lt;made up&gt; study &amp; more", "failed: a pivot &lt; 0 &amp; &quot;so on&quot;",
                              "left out: it would take 80 s, too long", "degree 3, normalized, cells x 1"})
        EXPECT_TRUE(has(page, words)) << words;
    EXPECT_FALSE(has(page, "nan")) << "a number that is none";
    EXPECT_FALSE(has(page, "http://") && !has(page, "http://www.w3.org/2000/svg")) << "no network";
}

/// Every point of a chart lies within its picture.
TEST(StudyFiles, PointsLieInsideTheirCharts) {
    const std::string page = study_html(synthetic::study(1.25));
    const std::regex circle("<circle cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\"");
    int n = 0;
    for (std::sregex_iterator i(page.begin(), page.end(), circle), none; i != none; ++i, ++n) {
        EXPECT_TRUE(std::stod((*i)[1]) > 0 && std::stod((*i)[1]) < 548) << (*i)[0];
        EXPECT_TRUE(std::stod((*i)[2]) > 0 && std::stod((*i)[2]) < 400) << (*i)[0];
    }
    EXPECT_GT(n, 9 * 6);  // levels and degree 2, in six charts
}

TEST(StudyFiles, ALineOfCsvForEachRun) {
    const Study study = synthetic::study(1);
    std::istringstream stream(study_csv(study));
    std::vector<std::vector<std::string>> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(fields(line));
    ASSERT_EQ(lines.size(), study.runs.size() + 1);
    for (const auto& line : lines) EXPECT_EQ(line.size(), lines[0].size());
    EXPECT_EQ(lines[0][lines[0].size() - 3], "error of pressure, \"L2\"");
    EXPECT_EQ(std::stod(lines[1][lines[1].size() - 3]), study.runs[0].error[0]);
    EXPECT_EQ(lines[lines.size() - 2].back(), "a pivot < 0 & \"so on\"");
    EXPECT_EQ(lines[lines.size() - 2][5], "failed");
}

TEST(StudyFiles, TheJsonHasRunsErrorsAndPrices) {
    const Study study = synthetic::study(1);
    const auto json = nlohmann::json::parse(study_json(study));
    ASSERT_EQ(json["runs"].size(), study.runs.size());
    for (std::size_t i = 0; i < study.runs.size(); ++i) {
        const bool ok = study.runs[i].status == StudyRun::Status::ok;
        EXPECT_EQ(json["runs"][i]["status"] == "ok", ok);
        EXPECT_EQ(json["runs"][i]["errors"][0].is_null(), !ok);
        if (ok) { EXPECT_EQ(json["runs"][i]["errors"][0].get<double>(), study.runs[i].error[0]); }
    }
    EXPECT_NEAR(json["measures"][0]["halving_the_error"][0]["factor"].get<double>(), 2, 1e-9);
    EXPECT_EQ(json["measures"][0]["cheapest"][0]["error"].get<double>(), 0.2);
}

TEST(StudyFiles, SentencesSayTheCosts) {
    const Study study = synthetic::study(1);
    std::string all;
    for (const std::string& s : study_sentences(study, 0)) all += s + "\n";
    EXPECT_TRUE(has(all, "0.5 % costs 3 ms (draft), ")) << all;
    EXPECT_TRUE(has(all, "12 ms (fine), contact and grids still to be found")) << all;
    EXPECT_TRUE(has(all, "Halving the error costs x 2 time with levels, x 2 with degree 1")) << all;
    EXPECT_TRUE(has(all, "Failed: 1 of degree 3, normalized;")) << all;
    EXPECT_TRUE(has(all, "Left out for the budget of 60 s: 1 of degree 4.")) << all;
    EXPECT_TRUE(has(study_table(study), "against a formula"));
}

}  // namespace
}  // namespace abut::study_files_test
