// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/section_target.hpp"
#include "tests/fuzz/trap.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    abut::fuzz::trap_on(abut::fuzz::fault_of_section({reinterpret_cast<const char*>(data), size}));
    return 0;
}
