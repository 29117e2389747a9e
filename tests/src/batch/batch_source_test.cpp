// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_source.hpp"

#include "geometry/brep/input_error.hpp"
#include "src/batch/batch_template.hpp"
#include "tests/src/io/folder_test.hpp"

namespace abut::batch_source_test {
namespace {

class BatchSourceTest : public FolderTest {
protected:
    std::vector<std::string> names(const std::string& source, const SourceOptions& options = {}) const {
        std::vector<std::string> result;
        for (const BatchJob& job : read_batch_source((folder_ / source).string(), options).jobs) result.push_back(job.name);
        return result;
    }
    std::size_t faults(const std::string& source, const SourceOptions& options = {}) const {
        try {
            read_batch_source((folder_ / source).string(), options);
        } catch (const InputError& error) { return error.problems().size(); }
        return 0;
    }
};

TEST_F(BatchSourceTest, TakesScenesDrawingsMeshesAndForeignCadOfAFolder) {
    for (const char* file : {"in/b.dxf", "in/a.json", "in/deep/c.STL", "in/d.step", "in/notes.md", "in/.hidden.dxf",
                             "in/.git/x.dxf", "in/out/jobs/a/result.json", "in/old/batch.json", "in/old/jobs/a/job.json"})
        write(file, "");
    const SourceOptions options{(folder_ / "in/out").string(), false};
    EXPECT_EQ(names("in", options), (std::vector<std::string>{"a.json", "b.dxf", "d.step", "deep-c.STL"}));
    EXPECT_EQ(read_batch_source((folder_ / "in").string(), options).left_out, (std::map<std::string, int>{{".md", 1}}));
    EXPECT_EQ(names("in", {options.excluded, true}), (std::vector<std::string>{"b.dxf", "d.step", "deep-c.STL"}));
}

TEST_F(BatchSourceTest, FollowsLinksAndLooksIntoEachFolderOnce) {
    namespace fs = std::filesystem;
    for (const char* file : {"in/a.dxf", "in/real/b.dxf", "far/c.dxf", "far/deep/d.dxf", "far/.hidden/x.dxf", "in/out/x.dxf"})
        write(file, "");
    const auto link = [&](const char* target, const char* name) { fs::create_symlink(folder_ / target, folder_ / name); };
    link("in/a.dxf", "in/also_a.dxf");     // a file: a job of its own name
    link("missing.dxf", "in/broken.dxf");  // a job that will say so
    link("far", "in/linked");              // followed
    link("far/deep", "in/by_link");        // before "linked" in the order of paths
    link("in/real", "in/0_again");         // looked into where it is
    link("in", "far/cycle");               // back to the source
    link("in/linked", "far/deep/chain");   // a link to a link, to the folder above
    link("", "in/up");                     // a folder that the source lies in
    link("in/out", "in/to_out");
    fs::create_symlink("self", folder_ / "in/self");  // leads nowhere
    const SourceOptions options{(folder_ / "in/out").string(), false};
    const BatchSource source = read_batch_source((folder_ / "in").string(), options);
    EXPECT_EQ(names("in", options),
              (std::vector<std::string>{"a.dxf", "also_a.dxf", "broken.dxf", "by_link-d.dxf", "linked-c.dxf", "real-b.dxf"}));
    EXPECT_EQ(source.jobs[3].file, (folder_ / "in/by_link/d.dxf").string());
    std::string said;
    for (const std::string& text : source.folders_left_out) said += text + "\n";
    for (const char* words :
         {"in/0_again: a link to ", "in/linked/cycle: a link to ", "in/by_link/chain: a link to a folder that it lies in",
          "in/up: a link to a folder that it lies in"})
        EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    EXPECT_EQ(source.folders_left_out.size(), 4U);
    EXPECT_EQ(source.left_out, (std::map<std::string, int>{{"", 1}}));  // "self"
}

TEST_F(BatchSourceTest, GivesNamesThatAreFoldersAndUnique) {
    write("in/a/b.dxf", "");
    write("in/a-b.dxf", "");
    EXPECT_EQ(names("in"), (std::vector<std::string>{"a-b.dxf", "a-b.dxf~2"}));
    write("list.txt", "# drawings\n../x.dxf\n\n  in/a/b.dxf\r\n../x.dxf\n");
    EXPECT_EQ(names("list.txt"), (std::vector<std::string>{"x.dxf", "in-a-b.dxf", "x.dxf~2"}));
    const BatchSource list = read_batch_source((folder_ / "list.txt").string(), {});
    EXPECT_EQ(list.jobs[1].file, (folder_ / "in/a/b.dxf").string());
    EXPECT_EQ(list.jobs[1].where, (folder_ / "list.txt").string() + ":4");
}

TEST_F(BatchSourceTest, NamesAreTextOfBoundedLengthAndStayApart) {
    const std::string far = std::string(150, 'd') + "/" + std::string(150, 'e') + "/";
    write("list.txt",
          "a\xFF"
          "b.dxf\n" +
              far + "x.dxf\n" + far + "x.dxf\n" + "d/" + far + "x.dxf\n../..\n");
    const auto all = names("list.txt");
    ASSERT_EQ(all.size(), 5U);
    EXPECT_EQ(all[0], "a_b.dxf");
    EXPECT_EQ(all[2], all[1] + "~2");
    EXPECT_NE(all[3].substr(0, 16), all[1].substr(0, 16));
    for (const std::string& name : all) EXPECT_LE(name.size(), 200U) << name;
    EXPECT_EQ(all[4], "job");
}

TEST_F(BatchSourceTest, ReadsTablesWithParameters) {
    write("t.csv", "file,name,P,gap\nx/a.dxf,one,1.5,\nx/a.dxf,,2,0.1\n");
    const BatchSource source = read_batch_source((folder_ / "t.csv").string(), {});
    ASSERT_EQ(source.jobs.size(), 2U);
    EXPECT_EQ(source.jobs[0].name, "one");
    EXPECT_EQ(source.jobs[1].name, "0002-x-a.dxf");
    EXPECT_EQ(source.jobs[0].parameters, (std::map<std::string, double>{{"P", 1.5}}));
    EXPECT_EQ(source.jobs[1].parameters, (std::map<std::string, double>{{"P", 2}, {"gap", 0.1}}));
    EXPECT_EQ(source.jobs[1].file, (folder_ / "x/a.dxf").string());
    write("t.jsonl", "{\"P\": 0.1}\n{\"P\": 3}\n");
    const BatchSource study = read_batch_source((folder_ / "t.jsonl").string(), {});
    EXPECT_FALSE(study.names_files);
    EXPECT_EQ(study.jobs[0].parameters.at("P"), 0.1);
    EXPECT_EQ(study.jobs[1].name, "0002");
}

TEST_F(BatchSourceTest, RefusesWhatIsNoSource) {
    EXPECT_EQ(faults("missing"), 1U);
    std::filesystem::create_directories(folder_ / "empty");
    EXPECT_EQ(faults("empty"), 1U);
    write("a.md", "x");
    EXPECT_EQ(faults("a.md"), 1U);
    write("bad.csv", "file,P\na.dxf,two\n,3\nb.dxf,1,5\n");
    EXPECT_EQ(faults("bad.csv"), 1U);  // the table itself first
    write("bad.csv", "file,P\na.dxf,two\n,3\nb.dxf,nan\n");
    EXPECT_EQ(faults("bad.csv"), 3U);
}

TEST_F(BatchSourceTest, SourceAndTemplateHaveToGoTogether) {
    const std::string any = write("any.json", R"({"abut": 1, "parameters": {"P": 1}, "assembly": {"file": "*"}})");
    const std::string own = write("own.json", R"({"abut": 1, "parameters": {"P": 1, "n": 2}, "parts": []})");
    const BatchTemplate any_file_template = read_template(any), own_parts = read_template(own);
    EXPECT_TRUE(any_file_template.takes_file);
    EXPECT_FALSE(own_parts.takes_file);
    write("files.csv", "file,P\na.dxf,1\n");
    write("study.csv", "P,n\n1,2\n");
    const BatchSource files = read_batch_source((folder_ / "files.csv").string(), {}),
                      study = read_batch_source((folder_ / "study.csv").string(), {});
    EXPECT_NO_THROW(check_template(files, &any_file_template));
    EXPECT_NO_THROW(check_template(files, nullptr));
    EXPECT_NO_THROW(check_template(study, &own_parts));
    EXPECT_THROW(check_template(files, &own_parts), InputError);
    EXPECT_THROW(check_template(study, nullptr), InputError);
    try {
        check_template(study, &any_file_template);
        FAIL();
    } catch (const InputError& error) { EXPECT_EQ(error.problems().size(), 2U); }  // no file, and no parameter n
}

}  // namespace
}  // namespace abut::batch_source_test
