// SPDX-License-Identifier: GPL-3.0-or-later
// The program abut-read-step: one STEP file through OpenCASCADE. Words after the file: the axis of the section (-1 to 2) and,
// where it is given, its place.
#include <Standard_Failure.hxx>
#include <cstdlib>

#include "apps/readers/step/step_file.hpp"
#include "apps/readers/step/step_section.hpp"
#include "geometry/brep/input_error.hpp"
#include "geometry/foreign/reader_main.hpp"

int main(int argc, char** argv) {
    using namespace abut::geometry;
    run_reader(argc, argv, [](const std::string& file, const std::vector<std::string>& words, RecordWriter& writer) {
        StepRecords records(writer);
        SectionChoice choice;
        if (!words.empty()) choice.axis = std::atoi(words[0].c_str());
        if (words.size() > 1) choice.at = std::strtod(words[1].c_str(), nullptr);
        try {
            write_section(read_step(file, records), choice, records);
        } catch (const Standard_Failure& failure) {
            throw abut::InputError(file, std::string("OpenCASCADE cannot read it (") + failure.GetMessageString() + ")",
                                   "export it again");
        }
    });
}
