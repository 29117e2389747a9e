// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/frontal_factor.hpp"

#include <algorithm>
#include <atomic>

#include "solver/linear_algebra/blas.hpp"
#include "solver/linear_algebra/front_tasks.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

/// One front of L: columns by columns, `rows` apart.
struct Front {
    int begin, width, rows;
    const int* row;
    double* values;

    int under() const { return rows - width; }
};

Front front_of(const Fronts& f, int s, double* values) {
    return {f.first_column[at(s)], f.width(s), f.rows(s), f.row.data() + f.first_row[at(s)], values + f.first_value[at(s)]};
}

void add(const double* from, int n, double* to) {
    for (int k = 0; k < n; ++k) to[k] += from[k];
}

/// The elimination under way.
struct FrontalElimination {
    const Fronts& fronts;
    const FrontTasks& tasks;
    double* values;
    std::vector<Numbers> rooms{};  // by task, while its updates are alive

    double* update_of(int front) const { return rooms[at(tasks.task_of[at(front)])].get() + tasks.update[at(front)]; }

    const FrontRun* run(int front) const { return fronts.run.data() + fronts.first_run[at(front)]; }

    /// The lower triangle of a child's update for the columns of some runs, to where its column 0 row 0 would stand; columns of
    /// that are `apart`.
    void add_columns(int child, const FrontRun* begin, const FrontRun* end, double* to, int apart) const {
        const FrontRun* last = run(child + 1);
        const int under = fronts.rows(child) - fronts.width(child);
        const double* update = update_of(child);
        for (const FrontRun* columns = begin; columns < end; ++columns)
            for (int c = columns->begin; c < columns->end; ++c) {
                const double* from = update + at(c) * at(under);
                double* column = to + at(columns->place + c - columns->begin) * at(apart);
                add(from + c, columns->end - c, column + columns->place + c - columns->begin);
                for (const FrontRun* rows = columns + 1; rows < last; ++rows)
                    add(from + rows->begin, rows->end - rows->begin, column + rows->place);
            }
    }

    /// The first of a child's runs that is below its parent's own columns.
    const FrontRun* below(int child, const Front& parent) const {
        return std::partition_point(run(child), run(child + 1), [&](const FrontRun& r) { return r.place < parent.width; });
    }

    void add_to_columns(const Front& f, int child) const { add_columns(child, run(child), below(child, f), f.values, f.rows); }
    void add_to_update(const Front& f, int child, double* update) const {
        const auto before = static_cast<std::ptrdiff_t>(f.width) * (f.under() + 1);
        add_columns(child, below(child, f), run(child + 1), update - before, f.under());
    }
    template <class F>
    void for_children(int s, F f) const {
        for (int k = fronts.first_child[at(s)]; k < fronts.first_child[at(s) + 1]; ++k) f(fronts.child[at(k)]);
    }

    /// The position of the pivot that is not positive, -1: none.
    int eliminate(int s) const {
        const Front f = front_of(fronts, s, values);
        for_children(s, [&](int child) { add_to_columns(f, child); });
        int info = 0;
        dpotrf_("L", &f.width, f.values, &f.rows, &info);
        if (info > 0) return f.begin + info - 1;
        const int under = f.under();
        if (under == 0) return -1;
        const double one = 1, minus = -1, zero = 0;
        double* update = update_of(s);
        dtrsm_("R", "L", "T", "N", &under, &f.width, &one, f.values, &f.rows, f.values + f.width, &f.rows);
        dsyrk_("L", "N", &under, &f.width, &minus, f.values + f.width, &f.rows, &zero, update, &under);
        for_children(s, [&](int child) { add_to_update(f, child, update); });
        return -1;
    }

    /// As eliminate(), of the first front of the task that has such a pivot.
    int eliminate_task(int k) {
        const FrontTask& task = tasks.task[at(k)];
        rooms[at(k)] = unset(task.room);
        for (int s : task.front) {
            if (const int position = eliminate(s); position >= 0) return position;
            for_children(s, [&](int child) {
                if (tasks.task_of[at(child)] != k) rooms[at(tasks.task_of[at(child)])].reset();
            });
        }
        return -1;
    }
};

}  // namespace

FrontalFactor::FrontalFactor(const SparseSymmetric& matrix, std::shared_ptr<const Fronts> fronts, int threads)
    : fronts_(std::move(fronts)), values_(zeros(at(fronts_->first_value.back()))) {
    for (std::size_t k = 0; k < matrix.value.size(); ++k) values_[at(fronts_->target[k])] = matrix.value[k];
    const FrontTasks tasks = make_front_tasks(*fronts_, largest_for(*fronts_, threads));
    FrontalElimination elimination{*fronts_, tasks, values_.get()};
    elimination.rooms.resize(tasks.task.size());
    std::vector<int> failed(tasks.task.size(), -1);
    std::vector<std::atomic<bool>> is_stuck(tasks.task.size());  // one below has failed
    for_front_tasks(tasks, threads, [&](int k) {
        if (!is_stuck[at(k)]) failed[at(k)] = elimination.eliminate_task(k);
        if (const int above = tasks.task[at(k)].above; above >= 0 && (is_stuck[at(k)] || failed[at(k)] >= 0))
            is_stuck[at(above)] = true;
    });
    // the same row for any number of threads: no front below a failed one fails, and the others have failed or not by
    // themselves
    for (int position : failed)
        if (position >= 0 && (failed_at_ < 0 || position < failed_at_)) failed_at_ = position;
    if (failed_at_ >= 0) failed_at_ = fronts_->order[at(failed_at_)];
}

Supernodes FrontalFactor::supernodes() const {
    return {fronts_->pattern(), values_.get()};
}

}  // namespace abut::solver
