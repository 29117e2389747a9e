// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/front_tasks.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "solver/linear_algebra/parallel_for.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

/// Multiplications that are worth one more thread: some milliseconds.
constexpr double least_work = 2e7;
/// Subtrees for each thread, at least.
constexpr double subtrees_of_thread = 4;

double work_of(const Fronts& f, int front) {
    const double w = f.width(front), under = f.rows(front) - w;
    return w * (w * w / 6 + w * under / 2 + under * under / 2);
}

/// Of every front; -1: it is a root.
std::vector<int> parents_of(const Fronts& f) {
    std::vector<int> parent(at(f.n_fronts()), -1);
    for (int s = 0; s < f.n_fronts(); ++s)
        for (int k = f.first_child[at(s)]; k < f.first_child[at(s) + 1]; ++k) parent[at(f.child[at(k)])] = s;
    return parent;
}

/// Of every front with all below it.
std::vector<double> subtree_work(const Fronts& f, const std::vector<int>& parent) {
    std::vector<double> work(parent.size(), 0);
    for (int s = 0; s < f.n_fronts(); ++s) {
        work[at(s)] += work_of(f, s);
        if (parent[at(s)] >= 0) work[at(parent[at(s)])] += work[at(s)];
    }
    return work;
}

double total_work(const Fronts& f) {
    double work = 0;
    for (int s = 0; s < f.n_fronts(); ++s) work += work_of(f, s);
    return work;
}

/// Subtrees of at most `largest`, and the fronts above them.
FrontTasks tasks_up_to(double largest, const Fronts& f, const std::vector<int>& parent) {
    const std::vector<double> work = subtree_work(f, parent);
    FrontTasks t;
    t.task_of.resize(parent.size());
    for (int s = f.n_fronts() - 1; s >= 0; --s) {
        const int above = parent[at(s)];
        const bool is_head = above < 0 || work[at(above)] > largest;
        t.task_of[at(s)] = is_head ? static_cast<int>(t.task.size()) : t.task_of[at(above)];
        if (!is_head) continue;
        t.task.emplace_back();
        if (above < 0) continue;
        t.task.back().above = t.task_of[at(above)];
        ++t.task[at(t.task.back().above)].n_below;
    }
    for (int s = 0; s < f.n_fronts(); ++s) {
        FrontTask& task = t.task[at(t.task_of[at(s)])];
        task.front.push_back(s);
        task.work += work_of(f, s);
    }
    return t;
}

FrontTasks one_task(const Fronts& f) {
    FrontTasks t;
    t.task.resize(1);
    t.task.front().front.resize(at(f.n_fronts()));
    std::iota(t.task.front().front.begin(), t.task.front().front.end(), 0);
    t.task_of.assign(at(f.n_fronts()), 0);
    return t;
}

/// First room that is free and large enough, from the bottom.
class Room {
public:
    std::size_t take(std::size_t size) {
        std::size_t begin = 0;
        auto next = taken_.begin();
        for (; next != taken_.end() && next->begin < begin + size; ++next) begin = next->end;
        taken_.insert(next, {begin, begin + size});
        largest_ = std::max(largest_, begin + size);
        return begin;
    }
    void give_back(std::size_t begin) {
        taken_.erase(std::find_if(taken_.begin(), taken_.end(), [&](const Stretch& s) { return s.begin == begin; }));
    }
    std::size_t largest() const { return largest_; }

private:
    struct Stretch {
        std::size_t begin, end;
    };
    std::vector<Stretch> taken_;  // ascending
    std::size_t largest_ = 0;
};

void place_updates(const Fronts& f, const std::vector<int>& task_of, FrontTask& task, std::vector<std::size_t>& update) {
    Room room;
    const auto size = [&](int s) { return at(f.rows(s) - f.width(s)) * at(f.rows(s) - f.width(s)); };
    for (int s : task.front) {
        update[at(s)] = size(s) > 0 ? room.take(size(s)) : 0;
        for (int k = f.first_child[at(s)]; k < f.first_child[at(s) + 1]; ++k)
            if (const int child = f.child[at(k)]; task_of[at(child)] == task_of[at(s)]) room.give_back(update[at(child)]);
    }
    task.room = room.largest();
}

}  // namespace

FrontTasks make_front_tasks(const Fronts& fronts, double largest) {
    FrontTasks t = std::isinf(largest) ? one_task(fronts) : tasks_up_to(largest, fronts, parents_of(fronts));
    t.update.resize(at(fronts.n_fronts()));
    for (FrontTask& task : t.task) place_updates(fronts, t.task_of, task, t.update);
    return t;
}

double largest_for(const Fronts& fronts, int threads) {
    const double work = threads > 1 ? total_work(fronts) : 0;
    const double worthwhile = std::min<double>(threads, 1 + std::floor(work / least_work));
    return worthwhile < 2 ? std::numeric_limits<double>::infinity() : work / (subtrees_of_thread * worthwhile);
}

void for_front_tasks(const FrontTasks& tasks, int threads, const std::function<void(int)>& work) {
    std::vector<int> leaves;
    std::vector<std::atomic<int>> waits_for(tasks.task.size());
    for (std::size_t k = 0; k < tasks.task.size(); ++k) {
        waits_for[k] = tasks.task[k].n_below;
        if (tasks.task[k].n_below == 0) leaves.push_back(static_cast<int>(k));
    }
    std::stable_sort(leaves.begin(), leaves.end(),
                     [&](int a, int b) { return tasks.task[at(a)].work > tasks.task[at(b)].work; });
    // who does the last task below another goes on with that one
    parallel_for(static_cast<int>(leaves.size()), threads, [&](int leaf) {
        for (int k = leaves[at(leaf)]; k >= 0;) {
            work(k);
            k = tasks.task[at(k)].above;
            if (k >= 0 && --waits_for[at(k)] > 0) k = -1;
        }
    });
}

}  // namespace abut::solver
