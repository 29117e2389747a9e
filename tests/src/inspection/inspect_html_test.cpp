// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `inspect`: every edge can be pointed at, under the name that selects it.
#include <gtest/gtest.h>

#include "src/inspection/inspect.hpp"

namespace abut::inspect_html_test {

TEST(InspectHtml, HasEveryEdgeUnderItsSelector) {
    const Inspection inspection = inspect_file(std::string(ABUT_SOURCE_DIR) + "/data/scenes/pin_bracket.json", {});
    const std::string page = inspection_html(inspection), picture = inspection_svg(inspection);
    std::size_t n = 0;
    for (const ScenePart& part : inspection.scene.parts)
        for (const geometry::Edge& edge : part.part.edges) {
            ++n;
            EXPECT_NE(page.find("data-edge=\"" + part.name + "/" + edge.name + "\""), std::string::npos) << edge.name;
        }
    EXPECT_GT(n, 10u);
    EXPECT_NE(page.find("line, length "), std::string::npos);
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    EXPECT_EQ(picture.find("data-edge"), std::string::npos);
}

}  // namespace abut::inspect_html_test
