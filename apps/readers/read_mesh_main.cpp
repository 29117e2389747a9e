// SPDX-License-Identifier: GPL-3.0-or-later
// The program abut-read-mesh: one mesh file through assimp or lib3mf. Words after the file: its format.
#include "apps/readers/read_3mf.hpp"
#include "apps/readers/read_scene_file.hpp"
#include "geometry/foreign/reader_main.hpp"

int main(int argc, char** argv) {
    using namespace abut::geometry;
    run_reader(argc, argv, [](const std::string& file, const std::vector<std::string>& words, RecordWriter& writer) {
        MeshRecords records(writer);
        const std::string format = words.empty() ? "" : words.front();
        if (format == "3MF")
            read_3mf(file, records);
        else
            read_scene_file(file, format, records);
    });
}
