// SPDX-License-Identifier: GPL-3.0-or-later
// Fronts of a multifrontal factorisation [Liu92] put together to tasks for several threads, and the room for their updates.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "solver/linear_algebra/fronts.hpp"

namespace abut::solver {

/// Fronts eliminated one after the other: a whole subtree, or one front above several tasks.
struct FrontTask {
    std::vector<int> front;  ///< ascending
    int above = -1;          ///< the task that takes in the last front's update; -1: none
    int n_below = 0;         ///< tasks that have to be done before
    double work = 0;         ///< multiplications
    std::size_t room = 0;    ///< for the updates of its fronts that are alive at one time
};

struct FrontTasks {
    std::vector<FrontTask> task;
    std::vector<int> task_of;         ///< by front
    std::vector<std::size_t> update;  ///< by front: where its update begins in the room of its task
};

/// Subtrees of at most so much work, and every front above them on its own; infinity: one task.
FrontTasks make_front_tasks(const Fronts& fronts, double largest);

/// Largest work of a subtree that keeps all threads busy; infinity for one thread, and where there is too little work for more.
double largest_for(const Fronts& fronts, int threads);

/// Calls work(task) once for each, those below before those above, on `threads` threads at most.
void for_front_tasks(const FrontTasks& tasks, int threads, const std::function<void(int)>& work);

}  // namespace abut::solver
