// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace abut::benchmarks {

/// From here on a new peak is counted. False where the system does not allow it: peak_memory() is then of the whole process.
bool forget_peak_memory();

/// Largest resident set, bytes; 0 where the system does not tell.
double peak_memory();

}  // namespace abut::benchmarks
