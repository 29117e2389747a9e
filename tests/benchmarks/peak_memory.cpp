// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/peak_memory.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

namespace abut::benchmarks {

bool forget_peak_memory() {
    malloc_trim(0);  // what earlier sizes have freed counts as resident otherwise
    std::ofstream file("/proc/self/clear_refs");
    file << "5" << std::flush;
    return file.good();
}

double peak_memory() {
    constexpr double kibibyte = 1024;
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (double size = 0; word == "VmHWM:" && status >> size) return kibibyte * size;
    return 0;
}

}  // namespace abut::benchmarks
