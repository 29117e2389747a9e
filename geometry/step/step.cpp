// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/step/step.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>

#include "geometry/foreign/readable_file.hpp"
#include "geometry/foreign/reader_process.hpp"
#include "geometry/step/step_records.hpp"

namespace abut::geometry {

namespace {

/// Read back to the same number.
std::string whole_number_text(double value) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

bool is_step_file(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension == ".step" || extension == ".stp";
}

Drawing read_step_file(const std::string& path, const SectionChoice& choice) {
    checked_size(path, most_step_bytes, "export fewer parts");
    // 41 MB with 8000 faces, splines among them, took 32 s on a slow machine and 460 MB, small files 0.2 s and 75 MB: five
    // times as much is allowed, and some seconds for a start.
    static const ForeignReader reader{
        "abut-read-step",
        "OpenCASCADE",
        "export it again, or as a mesh (3MF, STL)",
        "install libocct-data-exchange-dev and build abut again (apps/abut does so by itself), or export a mesh (3MF, STL)",
        512ull << 20,
        64,
        10,
        4};
    std::vector<std::string> words{std::to_string(choice.axis)};
    if (choice.at) words.push_back(whole_number_text(*choice.at));
    ReaderProcess process(reader, path, words);
    Drawing drawing;
    drawing.file = path;
    drawing.format = "STEP";
    read_step_records(process.records(), drawing);
    return drawing;
}

}  // namespace abut::geometry
