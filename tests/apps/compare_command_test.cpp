// SPDX-License-Identifier: GPL-3.0-or-later
// abut compare and abut report as a user calls them.
#include "tests/apps/command_line.hpp"

namespace abut_tests::compare_command_test {
namespace {

TEST_F(CommandLine, CompareTellsDifferences) {
    SceneText scene;
    write("a.json", scene.text());
    scene.loads = R"([{"on": "block/top", "pressure": 2}])";
    write("b.json", scene.text());
    ASSERT_EQ(abut({"analyze", "a.json", "-o", "a", "--quiet"}).status, 0);
    ASSERT_EQ(abut({"analyze", "b.json", "-o", "b", "--quiet"}).status, 0);
    const Outcome run = abut({"compare", "a", "b/result.json", "-o", "c"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"block", "max von Mises", "+100 %"})) << run.output;
    EXPECT_TRUE(any_line_has(lines_of(run.output), {"page: c/compare.html"}));
    const std::string page = read(folder_ / "c/compare.html");
    EXPECT_NE(page.find("+100 %"), std::string::npos);
    EXPECT_NE(page.find("\"cases\":[{\"name\":\"A\""), std::string::npos);
    EXPECT_EQ(abut({"compare", "a", "b", "--tolerance", "0.49", "--quiet"}).status, 1);
    EXPECT_EQ(abut({"compare", "a", "a", "--tolerance", "1e-12", "--quiet"}).status, 0);
    expect_refused(abut({"compare", "a"}), 1);
    expect_refused(abut({"compare", "a", "b", "a"}), 1);
    const Outcome nowhere = abut({"compare", "a", "nowhere"});
    expect_refused(nowhere, 1);
    EXPECT_TRUE(any_line_has(nowhere.errors, {"nowhere: there is no such file or folder"}));
    expect_refused(abut({"compare", "a", "a.json"}), 1);
    expect_refused(abut({"compare", "a", "b", "--tolerance", "-1"}), 1);
    fs::remove(folder_ / "a/report.html");
    expect_refused(abut({"compare", "a", "b", "-o", "d", "--quiet"}), 1);
}

TEST_F(CommandLine, ReportIsMadeAnew) {
    write("a.json", SceneText().text());
    ASSERT_EQ(abut({"analyze", "a.json", "-o", "a", "--quiet"}).status, 0);
    const std::string page = read(folder_ / "a/report.html");
    // as an older program would have written it
    std::string old = page;
    const std::size_t begin = old.find("<script>"), end = old.find("</script>", begin);
    old.replace(begin, end - begin, "<script>old");
    write("a/report.html", old);
    const Outcome run = abut({"report", "a"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    EXPECT_EQ(run.output, "report: a/report.html\n");
    std::string made = read(folder_ / "a/report.html");
    const std::size_t note = made.find(" This page was made anew by abut ");
    ASSERT_NE(note, std::string::npos);
    EXPECT_EQ(made.substr(0, note) + made.substr(made.find("</footer>", note)), page);
    EXPECT_EQ(abut({"report", "a", "--quiet"}).status, 0);
    EXPECT_EQ(read(folder_ / "a/report.html"), made) << "once is enough";
    write("a/report.html", "<html></html>");
    expect_refused(abut({"report", "a"}), 1);
    expect_refused(abut({"report", "nowhere"}), 1);
}

}  // namespace
}  // namespace abut_tests::compare_command_test
