// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/job_record.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "src/batch/batch_summary.hpp"
#include "src/batch/job_key.hpp"

namespace abut::job_record_test {
namespace {

JobRecord full_record() {
    JobRecord r;
    r.name = "a";
    r.file = "in/a.dxf";
    r.mode = "contacts";
    r.status = JobRecord::Status::differs;
    r.message = "1 difference, \"quoted\" <b>";
    r.key = "0123456789abcdef";
    r.parameters = {{"P", 0.1}, {"n", -3}};
    r.parts = 2;
    r.pairs = 1;
    r.max_pressure = 193.25;
    r.error_estimate = 0.03;
    r.warnings = {"one", "two"};
    r.expectation = ExpectationCount{2, 1, 1, 1, {"expected a - b, not found"}};
    r.files = {"contacts.json"};
    r.sizes = {17};
    r.seconds = 0.25;
    return r;
}

TEST(JobRecord, ComesBackAsItWas) {
    const std::string text = job_json(full_record());
    const auto back = parse_job_json(text);
    ASSERT_TRUE(back);
    EXPECT_EQ(job_json(*back), text);
    EXPECT_EQ(back->parameters.at("P"), 0.1);
    EXPECT_EQ(back->sizes, (std::vector<std::uintmax_t>{17}));
    EXPECT_FALSE(back->closed);
    JobRecord odd = full_record();
    odd.max_pressure = std::numeric_limits<double>::quiet_NaN();  // JSON has no word for it
    EXPECT_FALSE(parse_job_json(job_json(odd))->max_pressure);
}

TEST(JobRecord, WhatIsCutOffAnywhereIsNoRecord) {
    const std::string text = job_json(full_record());
    for (std::size_t n = 0; n + 2 < text.size(); ++n) EXPECT_FALSE(parse_job_json(text.substr(0, n))) << n;
    EXPECT_FALSE(parse_job_json(std::string(text.size(), '\0')));
    EXPECT_FALSE(parse_job_json("{\"abut\": 1}"));
}

TEST(JobKey, TellsEverySettingAndFileApart) {
    const std::string key = job_key({{"a", "b"}}, {{"x", "1"}});
    EXPECT_EQ(key, job_key({{"a", "b"}}, {{"elsewhere", "1"}}));
    for (const std::string& other :
         {job_key({{"a", "c"}}, {{"x", "1"}}), job_key({{"ab", ""}}, {{"x", "1"}}), job_key({{"a", "b"}}, {{"x", "2"}}),
          job_key({{"a", "b"}}, {}), job_key({{"a", "b"}, {"", ""}}, {{"x", "1"}}), job_key({{"a", "b1"}}, {})})
        EXPECT_NE(key, other);
    EXPECT_EQ(content_hash(""), "2d06800538d394c2");  // as xxhsum -H3 prints them
    EXPECT_EQ(content_hash("a"), "e6c632b61e964e1f");
}

TEST(BatchPage, ShowsAnswersWithReservations) {
    BatchSummary summary;
    summary.jobs = {full_record()};
    summary.jobs[0].status = JobRecord::Status::ok;
    summary.count[static_cast<std::size_t>(JobRecord::Status::ok)] = 1;
    EXPECT_NE(index_html(summary, "").find("<p class=\"verdict\">1 jobs: 1 ok"), std::string::npos);
    summary.jobs[0].status = JobRecord::Status::solved_but;
    std::swap(summary.count[0], summary.count[1]);
    EXPECT_NE(index_html(summary, "").find("<p class=\"verdict doubtful\">1 jobs: 1 solved_but"), std::string::npos);
    EXPECT_NE(index_html(summary, "").find("<span class=\"status solved_but\">"), std::string::npos);
    EXPECT_TRUE(all_well(summary));
    EXPECT_EQ(parse_job_json(job_json(summary.jobs[0]))->status, JobRecord::Status::solved_but);
    summary.jobs[0].status = JobRecord::Status::differs;
    EXPECT_FALSE(all_well(summary));
}

TEST(BatchPage, HoldsNoTextOfAFileAsMarkup) {
    BatchSummary summary;
    summary.jobs = {full_record()};
    summary.jobs[0].name = "<script>alert(1)</script>&\"";
    summary.count[static_cast<std::size_t>(JobRecord::Status::differs)] = 1;
    const std::string page = index_html(summary, "<i>");
    EXPECT_EQ(page.find("<script>alert"), std::string::npos);
    EXPECT_EQ(page.find("<b>"), std::string::npos);
    EXPECT_EQ(page.find("<i>"), std::string::npos);
    EXPECT_NE(page.find("%3Cscript%3E"), std::string::npos);
    EXPECT_NE(summary_csv(summary).find("\"1 difference, \"\"quoted\"\" <b>\""), std::string::npos);
}

TEST(BatchPage, HasColumnsThatSomeJobHasNumbersForAndMessagesWithoutFolders) {
    BatchSummary summary;
    summary.jobs = {full_record(), full_record()};
    summary.jobs[0].file = "/a/deep/folder/a.dxf";
    summary.jobs[0].message = "/a/deep/folder/a.dxf:12: is wrong in /a/deep/folder";
    EXPECT_NE(index_html(summary, "").find(">peak pressure<"), std::string::npos);
    EXPECT_NE(index_html(summary, "").find(">a.dxf:12: is wrong in /a/deep/folder<"), std::string::npos);
    EXPECT_EQ(index_html(summary, "").find(">closed<"), std::string::npos);
    summary.jobs[0].max_pressure.reset();
    EXPECT_NE(index_html(summary, "").find(">peak pressure<"), std::string::npos);  // the other job's
    summary.jobs[1].max_pressure.reset();
    EXPECT_EQ(index_html(summary, "").find(">peak pressure<"), std::string::npos);
    summary.jobs[1].closed = 2;
    EXPECT_NE(index_html(summary, "").find(">closed<"), std::string::npos);
}

}  // namespace
}  // namespace abut::job_record_test
