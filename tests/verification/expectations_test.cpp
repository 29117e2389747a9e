// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that know their answers.
#include "src/verification/expectations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/brep/input_error.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::expectations_test {

namespace {

/// A block 10 x 10 that is pressed by 4 on top and held below: its reaction is 40.
std::string block(const std::string& expect) {
    return R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0}},
        "parts": [{"name": "a", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [10, 10]}}}],
        "supports": [{"on": "a/bottom", "fix": ["x", "y"]}], "loads": [{"on": "a/top", "pressure": 4}],
        "output": {"probes": [{"part": "a", "at": [5, 10]}]}, "expect": )" +
           expect + "}";
}

std::vector<VerifyRow> rows_of(const std::string& expect) {
    const TemporaryFolder folder;
    return verify_scene(folder.write("block.json", block(expect)));
}

}  // namespace

TEST(Expectations, are_compared_by_dotted_paths_and_by_pointers) {
    const auto rows = rows_of(R"([{"quantity": "reactions[0].force[1]", "value": 40, "tolerance": 1e-6, "source": "statics"},
        {"quantity": "/probes/0/displacement/1", "value": -0.04, "tolerance": 1e-6},
        {"quantity": "reactions[0].force[0]", "value": 0, "tolerance": 1e-6},
        {"quantity": "reactions[0].force[1]", "value": 41, "tolerance": 0.01}])");
    ASSERT_EQ(rows.size(), 4u);
    for (std::size_t k : {0u, 1u, 2u}) EXPECT_TRUE(rows[k].pass) << rows[k].quantity << " " << rows[k].value;
    EXPECT_FALSE(rows[3].pass);
    EXPECT_TRUE(rows[0].name.ends_with("block.json"));  // scenes of several folders may have one name
    EXPECT_EQ(rows[0].quantity, "reactions[0].force[1] (statics)");
    EXPECT_NEAR(rows[3].relative_error, 1.0 / 41, 1e-6);
    EXPECT_GT(rows[0].seconds, 0);
}

TEST(Expectations, that_no_number_answers_do_not_pass) {
    const auto rows = rows_of(R"([{"quantity": "reaction[0].force[1]", "value": 40, "tolerance": 1},
        {"quantity": "reactions[7].force[1]", "value": 40, "tolerance": 1},
        {"quantity": "reactions[0].force[1].value", "value": 40, "tolerance": 1},
        {"quantity": "reactions[0].method", "value": 40, "tolerance": 1}])");
    ASSERT_EQ(rows.size(), 4u);
    for (const VerifyRow& row : rows) EXPECT_TRUE(!row.pass && std::isnan(row.value)) << row.quantity;
    EXPECT_NE(rows[0].failure.find("there is no 'reaction'; did you mean 'reactions'?"), std::string::npos) << rows[0].failure;
    EXPECT_NE(rows[1].failure.find("there is no item '7' in a list of 1"), std::string::npos) << rows[1].failure;
    EXPECT_NE(rows[2].failure.find("nothing is inside a single value"), std::string::npos) << rows[2].failure;
    EXPECT_NE(rows[3].failure.find("this is no number"), std::string::npos) << rows[3].failure;
}

TEST(Expectations, are_found_below_a_folder) {
    const TemporaryFolder folder;
    const std::string known = R"([{"quantity": "reactions[0].force[1]", "value": 40, "tolerance": 1e-6}])";
    const std::string first = folder.write("a.json", block(known)), second = folder.write("b.json", block(known));
    folder.write("result.json", "{}");
    EXPECT_EQ(scenes_with_expectations(folder.path("")), (std::vector<std::string>{first, second}));
    EXPECT_EQ(scenes_with_expectations(second), std::vector<std::string>{second});
    EXPECT_THROW(scenes_with_expectations(folder.write("c.json", "{}")), InputError);
}

TEST(Expectations, of_a_scene_that_cannot_be_read_are_a_row_that_fails) {
    const TemporaryFolder folder;
    const std::string broken = folder.write("broken.json", R"({"expect": [)");
    EXPECT_EQ(scenes_with_expectations(folder.path("")), std::vector<std::string>{broken});
    const auto rows = verify_scene(broken);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_FALSE(rows[0].pass);
    EXPECT_NE(rows[0].failure.find("broken.json"), std::string::npos) << rows[0].failure;
}

TEST(Expectations, are_checked_when_the_scene_is_read) {
    const auto fault = [](const std::string& expect) -> std::string {
        try {
            read_scene_text(block(expect), "scene.json");
        } catch (const InputError& error) { return error.what(); }
        return "no error";
    };
    EXPECT_NE(
        fault(R"([{"quantity": "reactions[0].force[1]", "value": 40}])").find("/expect/0: the key 'tolerance' is missing"),
        std::string::npos);
    EXPECT_NE(fault("[]"), "no error");
    EXPECT_NE(fault(R"([{"quantity": "", "value": 40, "tolerance": 1}])").find("/expect/0/quantity: this text is empty"),
              std::string::npos);
    EXPECT_NE(fault(R"([{"quantity": "q", "value": 40, "tolerance": 0}])").find("'tolerance' must be greater than 0"),
              std::string::npos);
}

}  // namespace abut::expectations_test
