// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/expected_pairs.hpp"

#include "geometry/brep/input_error.hpp"
#include "src/batch/batch_summary.hpp"
#include "tests/src/io/folder_test.hpp"

namespace abut::expected_pairs_test {
namespace {

DetectedPair pair(const std::string& a, const std::string& b, const std::string& status = "touching") {
    DetectedPair p;
    p.parts = {a, b};
    p.edges = {std::vector<std::string>{a + "/e0"}, std::vector<std::string>{b + "/e0"}};
    p.status = status;
    return p;
}

TEST(ExpectedPairs, CountsWhatIsFoundAndWhatIsNot) {
    Detection detection;
    detection.pairs = {pair("a", "b"), pair("b", "c"), pair("c", "d", "gap")};
    const ExpectationCount count =
        count_expected(detection, {{{"b", "a"}, "", ""}, {{"c", "d/e0"}, "touching", ""}, {{"a", "d"}, "", ""}});
    EXPECT_EQ(count.expected, 3);
    EXPECT_EQ(count.expected_found, 1);
    EXPECT_EQ(count.detected, 3);
    EXPECT_EQ(count.detected_expected, 1);
    ASSERT_EQ(count.differences.size(), 3U);
    EXPECT_NE(count.differences[0].find("status gap, expected touching"), std::string::npos);
    EXPECT_NE(count.differences[1].find("expected a - d, not found"), std::string::npos);
    EXPECT_NE(count.differences[2].find("found b - c, not expected"), std::string::npos);
    const std::string text = expectation_text(count);
    EXPECT_NE(text.find("precision 0.3333 (1 of 3"), std::string::npos) << text;
    EXPECT_NE(expectation_text({}).find("precision - (0 of 0"), std::string::npos);
}

TEST(ExpectedPairs, ARowAZoneIsOnePairAsCloseAsItsClosestRow) {
    Detection detection;
    detection.pairs = {pair("a", "b", "gap"), pair("a", "b"), pair("b", "c", "gap")};
    detection.pairs[0].interface = "flat-on-flat";
    detection.pairs[1].interface = "round-on-flat";
    EXPECT_EQ(count_pairs(detection), 2);
    const auto differences = [&](const std::string& status, const std::string& interface) {
        return count_expected(detection, {{{"a", "b"}, status, interface}, {{"b", "c"}, "", ""}}).differences.size();
    };
    EXPECT_EQ(differences("touching", "round-on-flat"), 0U);
    EXPECT_EQ(differences("gap", ""), 1U);
    EXPECT_EQ(differences("touching", "flat-on-flat"), 1U);
}

class ExpectationTableTest : public FolderTest {};

TEST_F(ExpectationTableTest, ReadsRowsAndFilesWithoutPairs) {
    const ExpectationTable table =
        read_expectation_table(write("e.csv", "file,part_1,part_2,status\na.dxf,p,q,gap\na.dxf,p,r\nb.dxf,,\n"));
    ASSERT_TRUE(expected_for(table, {"none", "a.dxf"}));
    EXPECT_EQ(expected_for(table, {"a.dxf"})->size(), 2U);
    EXPECT_EQ(expected_for(table, {"a.dxf"})->front().status, "gap");
    EXPECT_EQ(expected_for(table, {"b.dxf"})->size(), 0U);
    EXPECT_EQ(expected_for(table, {"c.dxf"}), nullptr);
}

TEST_F(ExpectationTableTest, NamesWhatIsWrong) {
    try {
        read_expectation_table(write("e.csv", "file,part_1,part_2,stauts\n,p,q\na.dxf,p\n"));
        FAIL();
    } catch (const InputError& error) {
        ASSERT_EQ(error.problems().size(), 3U);
        EXPECT_NE(error.problems()[0].hint.find("status"), std::string::npos);
    }
    EXPECT_THROW(read_expectation_table(write("e.json", "{}")), InputError);
}

}  // namespace
}  // namespace abut::expected_pairs_test
