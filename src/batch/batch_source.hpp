// SPDX-License-Identifier: GPL-3.0-or-later
// What a batch is made of: the jobs that a folder, a list or a table stands for.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace abut {

/// One job: a name, a file and values of parameters.
struct BatchJob {
    std::string name;  ///< of its folder: unique in the batch, without '/', the same on every machine and for every shard
    std::string file;  ///< scene, drawing or mesh; empty: the template alone
    std::map<std::string, double> parameters;  ///< of the scene, instead of its own
    std::string where;                         ///< "table.csv:12", for messages; empty: a file of a folder
};

/// The jobs of a batch, and what was left out.
struct BatchSource {
    std::vector<BatchJob> jobs;                     ///< in the order of the table or list, else by name
    std::map<std::string, std::string> parameters;  ///< columns of the table that stand for parameters, and where they stand
    std::map<std::string, int> left_out;        ///< files of a folder that are neither scenes nor drawings: number by ending
    std::vector<std::string> folders_left_out;  ///< folders that were not looked into, "in/link: why"
    bool names_files = true;                    ///< false: a table without the column "file"
};

struct SourceOptions {
    std::string excluded;        ///< a folder that is not looked into: the one that the batch writes
    bool only_drawings = false;  ///< a folder's scenes are left out: there is a template
};

/// Reads the SOURCE of `abut batch`: a folder with all its folders (scenes, drawings, meshes, and other CAD files, which end as
/// errors; not what begins with a dot; links are followed, src/io/folder_walk.hpp), a table (.csv, .jsonl) with the columns
/// "file", "name" and parameters, a list (.txt: a file a line, # begins a comment), or a single scene, drawing or mesh. Files
/// are relative to the folder of the list or table. A job has the name of its file with "/" as "-", one of a table its row's
/// number before it unless the table names it. A listed file that does not exist only shows in its job. Throws InputError where
/// there is no source, or it is wrong or empty. Cost: one look at each file's name.
BatchSource read_batch_source(const std::string& source, const SourceOptions& options);

}  // namespace abut
