// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the linear algebra library that the program runs with may be called from several threads at once.
#pragma once

namespace abut::solver {

/// How many threads to use where `wanted` are asked for (0: one for each processor). One where the library is OpenBLAS built
/// without threads or with those of OpenMP: there two calls at once may take the same piece of its memory (without threads 15
/// of 40 000 products came out wrong when two threads made them). From then on OpenBLAS uses no threads of its own.
int usable_threads(int wanted);

}  // namespace abut::solver
