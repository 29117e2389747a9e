// SPDX-License-Identifier: GPL-3.0-or-later
// How the program takes memory from the system.
#pragma once

namespace abut {

/// Freed memory is kept for what comes next, and taken in large pages: an analysis of some tens of milliseconds solves several
/// grids in the same memory, and would else spend a tenth of its time on pages handed back and forth. Allocations of 32 MiB and
/// more go back to the system as before. To be called first in main(); does nothing where the C library is another than GNU's.
void keep_heap();

}  // namespace abut
