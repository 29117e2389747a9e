// SPDX-License-Identifier: GPL-3.0-or-later
// Independent pieces of work side by side: parts of an assembly, fronts and rows of one of them.
#pragma once
#include <functional>

namespace abut::solver {

/// Calls work(0) to work(n - 1), each once, on `threads` threads at most, the calling one among them; with one thread or one
/// piece none is started. The work writes to places of its own, so that its results are the same for any number of threads.
/// Where calls throw, all others are made all the same, and the exception of the lowest number is thrown again.
void parallel_for(int n, int threads, const std::function<void(int)>& work);

}  // namespace abut::solver
