// SPDX-License-Identifier: GPL-3.0-or-later
// A reader that does what the first line of its file says: the faults of libraries, at will.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <vector>

#include "geometry/brep/input_error.hpp"
#include "geometry/foreign/reader_main.hpp"

namespace {

using abut::geometry::RecordWriter;

void misbehave(const std::string& how) {
    if (how == "crash") std::abort();
    if (how == "loop")
        for (volatile bool on = true; on;) {}
    if (how == "sleep")
        for (;;) ::sleep(1);
    if (how == "eat")
        for (std::vector<std::unique_ptr<char[]>> all;;) all.push_back(std::make_unique<char[]>(1 << 20));
    if (how == "leave") ::_exit(0);
    if (how == "throw") throw std::runtime_error("a library's own words");
    if (how == "refuse") throw abut::InputError("", "the file is no good", "make a better one");
    if (how == "talk") std::puts("libraries talk"), std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    abut::geometry::run_reader(argc, argv,
                               [](const std::string& file, const std::vector<std::string>& words, RecordWriter& records) {
                                   std::ifstream in(file);
                                   std::string how;
                                   std::getline(in, how);
                                   records.kind('t');
                                   records.text(words.empty() ? "" : words.front());
                                   if (how == "late") records.flush(), std::abort();
                                   if (how == "garble") records.kind('t'), records.count(std::size_t{1} << 60);
                                   misbehave(how);
                               });
}
