// SPDX-License-Identifier: GPL-3.0-or-later
// `abut help` from outside: commands, keys, the pages made from the schemas.
#include <gtest/gtest.h>

#include "tests/apps/command_line.hpp"

namespace help_command_test {
namespace {

using namespace abut_tests;

TEST_F(CommandLine, HelpAloneIsTheGeneralHelpAndOfACommandItsOwn) {
    EXPECT_EQ(abut({"help"}).output, abut({"--help"}).output);
    EXPECT_EQ(abut({"help", "analyze"}).output, abut({"analyze", "--help"}).output);
    expect_words(abut({"--help"}).output, {"help", "abut help KEY"});
    expect_words(abut({"help", "help"}).output, {"TOPIC", "--markdown", "--man"});
}

TEST_F(CommandLine, HelpExplainsAKey) {
    for (const char* words : {"loads.gravity", "loads[].gravity", "scene.loads.gravity", "gravity"}) {
        const Outcome run = abut({"help", words});
        EXPECT_EQ(run.status, 0) << words << joined(run.errors);
        expect_words(run.output, {"scene.loads[].gravity", "[x, y]", "length per time^2", "density"});
    }
    expect_words(abut({"help", "scene.contacts.friction"}).output, {"scene.contacts.friction", "default  0", "rough"});
    expect_words(abut({"help", "result.contacts.profile.pressure"}).output, {"force per length^2"});
    expect_words(abut({"help", "materials.steel.E", "loads.on.near"}).output,
                 {"scene.materials.*.E", "scene.supports[].on.near"});
}

TEST_F(CommandLine, HelpListsWhatAWordMayMeanAndHintsWhereItMeansNothing) {
    const Outcome several = abut({"help", "pressure"});
    EXPECT_EQ(several.status, 0);
    expect_words(several.output, {"scene.loads[].pressure", "result.contacts[].profile.pressure", "csv.contact.pressure"});
    expect_words(abut({"help", "contacts"}).output, {"usage: abut contacts", "scene.contacts", "contacts.json"});

    const Outcome unknown = abut({"help", "loads.forze"});
    expect_refused(unknown, 1);
    expect_words(joined(unknown.errors), {"'loads.forze'", "did you mean 'loads.force'"});
    expect_refused(abut({"help", "analyse"}), 1);
}

TEST_F(CommandLine, ThePagesOfTheReferenceAreThoseOfTheSchemas) {
    const std::string pages = read(fs::path(ABUT_SOURCE_DIR) / "data/schema/README.md");
    EXPECT_TRUE(abut({"help", "--markdown"}).output == pages) << "data/schema/README.md is not what the schemas say; write it "
                                                                 "again: apps/abut help --markdown > data/schema/README.md";
    EXPECT_NE(pages.find("`loads[].force`"), std::string::npos);
}

TEST_F(CommandLine, TheManPageHasCommandsAndKeys) {
    const std::string man = abut({"help", "--man"}).output;
    EXPECT_EQ(man.rfind(".TH ABUT 1\n", 0), 0U);
    expect_words(man, {".SS abut analyze SCENE", ".B \\-\\-accuracy A", ".B loads[].force", ".SH KEYS OF RESULT.JSON"});
    for (const std::string& line : lines_of(man))
        if (line.starts_with('.')) {
            EXPECT_TRUE(std::regex_search(line, std::regex("^\\.(TH|SH|SS|TP|B|PP|IP|nf|fi)( |$)")))
                << "no request of roff: " << line;
        }
}

TEST_F(CommandLine, EveryKeyThatCompletionOffersIsExplained) {
    const std::vector<std::string> keys = lines_of(abut({"help", "--keys"}).output);
    EXPECT_GT(keys.size(), 300U);
    std::vector<std::string> words{"help"};
    words.insert(words.end(), keys.begin(), keys.end());
    const Outcome run = abut(words);
    EXPECT_EQ(run.status, 0) << joined(run.errors);
}

}  // namespace
}  // namespace help_command_test
