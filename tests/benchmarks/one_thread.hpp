// SPDX-License-Identifier: GPL-3.0-or-later
// Linear algebra on one thread, and the time that this thread computes: figures that a busy machine changes little.
#pragma once

namespace abut::benchmarks {

/// From here on OpenBLAS and OpenMP use the calling thread only, in the whole process; where they are not linked in, nothing
/// is to be done.
void use_one_thread();

/// Seconds that the calling thread has computed.
double thread_seconds();

/// Of one call.
template <class F>
double thread_seconds_of(F f) {
    const double begin = thread_seconds();
    f();
    return thread_seconds() - begin;
}

}  // namespace abut::benchmarks
