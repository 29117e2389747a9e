// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/parallel_for.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace abut::solver {

void parallel_for(int n, int threads, const std::function<void(int)>& work) {
    std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(std::max(n, 0)));
    std::atomic<int> next = 0;
    const auto run = [&] {
        for (int i = next++; i < n; i = next++) {
            try {
                work(i);
            } catch (...) { thrown[static_cast<std::size_t>(i)] = std::current_exception(); }
        }
    };
    {
        std::vector<std::jthread> others;
        for (int k = 1; k < std::min(threads, n); ++k) others.emplace_back(run);
        run();
    }
    for (const std::exception_ptr& e : thrown)
        if (e) std::rethrow_exception(e);
}

}  // namespace abut::solver
