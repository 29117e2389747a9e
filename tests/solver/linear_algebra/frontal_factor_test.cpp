// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/frontal_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>
#include <random>

#include "solver/linear_algebra/blas_threads.hpp"
#include "solver/linear_algebra/factorization.hpp"
#include "solver/linear_algebra/front_tasks.hpp"
#include "solver/parts/row_hints.hpp"
#include "tests/solver/linear_algebra/sparse_of.hpp"
#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::frontal_factor_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A matrix on some places of a grid: one or two rows a place, coupled up to the reach and, some of them, anywhere.
struct OnGrid {
    MatrixXd dense;
    RowHints hints;
};

OnGrid random_part(int columns, int rows, int reach, double filled, unsigned seed, double far = 0.002) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1), share(0, 1);
    OnGrid part;
    part.hints.reach = reach;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            for (int k = share(random) > filled ? 2 : share(random) < 0.1 ? 1 : 0; k < 2; ++k)
                part.hints.place.push_back({x, y});
    const auto n = static_cast<Eigen::Index>(part.hints.place.size());
    part.dense = MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < i; ++j) {
            const GridPlace &a = part.hints.place[static_cast<std::size_t>(i)],
                            &b = part.hints.place[static_cast<std::size_t>(j)];
            const bool near = std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1])) <= reach;
            if (near || share(random) < far) part.dense(i, j) = part.dense(j, i) = number(random);
        }
    for (Eigen::Index i = 0; i < n; ++i) part.dense(i, i) = 0.1 + part.dense.row(i).cwiseAbs().sum();
    return part;
}

/// Reaches, shapes, holes: from one front to many, and pieces that hang together by nothing.
template <class F>
void for_parts(F f) {
    unsigned seed = 1;
    for (int reach : {1, 2, 3})
        for (const auto& [columns, rows] :
             {std::pair(1, 1), std::pair(4, 3), std::pair(40, 2), std::pair(3, 50), std::pair(13, 17)})
            for (double filled : {1.0, 0.7, 0.2}) f(random_part(columns, rows, reach, filled, ++seed));
}

Fronts fronts_of(const SparseSymmetric& matrix, const RowHints& hints, int leaf) {
    const MergedPattern pattern = merged_pattern(matrix);
    GridPlaces nodes{{}, hints.reach};
    for (int k = 0; k < pattern.n_nodes(); ++k)
        nodes.at.push_back(hints.place[static_cast<std::size_t>(pattern.first_column[static_cast<std::size_t>(k)])]);
    return make_fronts(matrix, pattern, dissected(nodes, leaf));
}

Fronts fronts_of(const OnGrid& part, int leaf) {
    return fronts_of(sparse(part.dense), part.hints, leaf);
}

Factorization frontal(const OnGrid& part) {
    RowHints hints = part.hints;
    hints.method = FactorMethod::frontal;
    return Factorization(sparse(part.dense), hints);
}

MatrixXd random_columns(Eigen::Index rows, Eigen::Index columns) {
    std::mt19937 random(11);
    std::normal_distribution<double> number;
    return MatrixXd::NullaryExpr(rows, columns, [&]() { return number(random); });
}

// diagonally dominant: condition below 1e3, rounding below 1e-12
constexpr double rounding = 1e-12;

}  // namespace

TEST(FrontalFactor, SolvesLikeADenseOne) {
    for_parts([](const OnGrid& part) {
        const Eigen::Index n = part.dense.rows();
        if (n == 0) return;
        const Factorization f = frontal(part);
        ASSERT_TRUE(f.ok());
        EXPECT_EQ(f.method(), FactorMethod::frontal);
        const MatrixXd b = random_columns(n, 5);
        const MatrixXd x = part.dense.llt().solve(b);
        for (Eigen::Index k = 0; k < b.cols(); ++k)
            EXPECT_LE((f.solve(b.col(k)) - x.col(k)).norm(), rounding * x.col(k).norm()) << n;
    });
}

TEST(FrontalFactor, FormsOfTheInverseAreThoseOfADenseOne) {
    for_parts([](const OnGrid& part) {
        const Eigen::Index n = part.dense.rows();
        if (n == 0) return;
        const Factorization f = frontal(part);
        MatrixXd b = random_columns(n, 7);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index k = 0; k < b.cols(); ++k)
                if ((i + 3 * k) % 11 > 2) b(i, k) = 0;
        const MatrixXd form = b.transpose() * part.dense.llt().solve(b);
        EXPECT_LE((f.inverse_form(b.sparseView()) - form).norm(), rounding * form.norm()) << n;
        const MatrixXd y = f.solve_lower(b);
        EXPECT_LE((y.transpose() * y - form).norm(), rounding * form.norm()) << n;
    });
}

TEST(FrontalFactor, ProductGivesTheMatrixBack) {
    for_parts([](const OnGrid& part) {
        const Eigen::Index n = part.dense.rows();
        if (n == 0) return;
        const FrontalFactor f(sparse(part.dense), std::make_shared<const Fronts>(fronts_of(part, 4)));
        const VectorXd x = random_columns(n, 1);
        EXPECT_LE((f.supernodes().product(x) - part.dense * x).norm(), rounding * (part.dense * x).norm()) << n;
        int row = -1;
        EXPECT_GT(f.supernodes().smallest_pivot(row), 0);
        EXPECT_TRUE(row >= 0 && row < n);
    });
}

TEST(FrontalFactor, NamesTheRowThatIsNotPositive) {
    const OnGrid part = random_part(13, 17, 2, 0.8, 5);
    const auto fronts = std::make_shared<const Fronts>(fronts_of(part, 16));
    for (Eigen::Index bad = 0; bad < part.dense.rows(); bad += 17) {
        MatrixXd a = part.dense;
        a(bad, bad) = -1;  // what is eliminated before lowers it, and does not depend on it
        EXPECT_EQ(FrontalFactor(sparse(a), fronts).failed_at(), static_cast<int>(bad));
    }
}

TEST(FrontalFactor, IsTheSameBitForBit) {
    const OnGrid part = random_part(30, 30, 2, 0.8, 9);
    const VectorXd b = random_columns(part.dense.rows(), 1);
    const VectorXd x = frontal(part).solve(b);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(frontal(part).solve(b), x);
}

TEST(Fronts, HoldEveryEntryOnce) {
    for_parts([](const OnGrid& part) {
        const Fronts f = fronts_of(part, 8);
        std::vector<int> targets = f.target;
        std::sort(targets.begin(), targets.end());
        EXPECT_EQ(std::adjacent_find(targets.begin(), targets.end()), targets.end());
        EXPECT_TRUE(targets.empty() || targets.back() < f.first_value.back());
        EXPECT_EQ(f.first_column.back(), part.dense.rows());
    });
}

/// From one task to one for each front.
template <class F>
void for_tasks(F f) {
    for_parts([&](const OnGrid& part) {
        const Fronts fronts = fronts_of(part, 8);
        for (double largest : {0.0, 1e3, 1e4, std::numeric_limits<double>::infinity()})
            f(fronts, make_front_tasks(fronts, largest));
    });
}

TEST(FrontTasks, UpdatesThatAreAliveDoNotOverlap) {
    for_tasks([](const Fronts& f, const FrontTasks& t) {
        std::vector<std::vector<int>> owner;  // by task: front whose update is in the room
        for (const FrontTask& task : t.task) owner.emplace_back(task.room, -1);
        for (int s = 0; s < f.n_fronts(); ++s) {
            const auto front = static_cast<std::size_t>(s);
            std::vector<int>& own = owner[static_cast<std::size_t>(t.task_of[front])];
            const std::size_t under = static_cast<std::size_t>(f.rows(s) - f.width(s)), size = under * under;
            ASSERT_LE(t.update[front] + size, own.size());
            for (std::size_t k = t.update[front]; k < t.update[front] + size; ++k) {
                ASSERT_EQ(own[k], -1);
                own[k] = s;
            }
            for (int c = f.first_child[front]; c < f.first_child[front + 1]; ++c) {
                const auto child = static_cast<std::size_t>(f.child[static_cast<std::size_t>(c)]);
                std::vector<int>& room = owner[static_cast<std::size_t>(t.task_of[child])];
                std::replace(room.begin(), room.end(), static_cast<int>(child), -1);
            }
        }
    });
}

TEST(FrontTasks, EveryFrontIsDoneOnceAfterThoseBelowIt) {
    for_tasks([](const Fronts& f, const FrontTasks& t) {
        for (int threads : {1, 3}) {
            std::vector<std::atomic<int>> done(static_cast<std::size_t>(f.n_fronts()));
            for_front_tasks(t, threads, [&](int k) {
                for (int s : t.task[static_cast<std::size_t>(k)].front) {
                    const auto front = static_cast<std::size_t>(s);
                    for (int c = f.first_child[front]; c < f.first_child[front + 1]; ++c)
                        EXPECT_EQ(done[static_cast<std::size_t>(f.child[static_cast<std::size_t>(c)])], 1);
                    ++done[front];
                }
            });
            EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](const auto& n) { return n == 1; }));
        }
    });
}

/// A plate of 50 x 50 cells, held in some coefficients.
struct Plate {
    SparseSymmetric matrix;
    RowHints hints;
};
Plate plate() {
    const PartInput part = test::rectangle(1, 1, 50, 50, 2);
    const BlockMatrix k = assemble_stiffness(part);
    std::vector<int> number(static_cast<std::size_t>(2 * k.n), -1);
    for (int i = 7; i < 2 * k.n; ++i) number[static_cast<std::size_t>(i)] = i - 7;
    return {restricted(k, number, 2 * k.n - 7), row_hints(part, number)};
}

TEST(FrontTasks, ALargePartHasManyAndASmallOneHasOne) {
    const Plate p = plate();
    const Fronts fronts = fronts_of(p.matrix, p.hints, 16);
    EXPECT_GE(make_front_tasks(fronts, largest_for(fronts, 2)).task.size(), 8u);
    EXPECT_EQ(make_front_tasks(fronts, largest_for(fronts, 1)).task.size(), 1u);
    const Fronts few = fronts_of(random_part(13, 17, 1, 1, 3), 8);
    EXPECT_EQ(make_front_tasks(few, largest_for(few, 8)).task.size(), 1u);
}

TEST(FrontalFactor, IsTheSameOnAnyNumberOfThreads) {
    usable_threads(1);  // as in the program: BLAS makes none of its own
    const Plate p = plate();
    const Factorization alone(p.matrix, p.hints);
    ASSERT_EQ(alone.method(), FactorMethod::frontal);
    const MatrixXd b = random_columns(p.matrix.n, 3);
    for (int threads : {2, 3, 16}) {
        const Factorization together(p.matrix, p.hints, usable_threads(threads));
        EXPECT_EQ(together.solve_lower(b), alone.solve_lower(b)) << threads;
    }
}

TEST(FrontalFactor, FailsAtTheSameRowOnAnyNumberOfThreads) {
    usable_threads(1);
    std::mt19937 random(5);
    for (int trial = 0; trial < 20; ++trial) {
        Plate p = plate();
        for (int k = 0; k < 3; ++k) {  // pivots below zero in some places
            const auto row = static_cast<std::size_t>(random() % static_cast<unsigned>(p.matrix.n));
            p.matrix.value[static_cast<std::size_t>(p.matrix.first[row])] *= 0.3;
        }
        const int row = Factorization(p.matrix, p.hints).failed_at();
        ASSERT_GE(row, 0);
        for (int threads : {2, 5}) EXPECT_EQ(Factorization(p.matrix, p.hints, usable_threads(threads)).failed_at(), row);
    }
}

TEST(GridDissection, EntriesGrowLikeNestedDissection) {
    const auto entries = [](int n) {
        const OnGrid part = random_part(n, n, 1, 1, 1, 0);
        return Factorization(sparse(part.dense), part.hints).entries() / static_cast<double>(part.dense.rows());
    };
    // per row: with the logarithm; a band's would double
    EXPECT_LT(entries(32), 1.5 * entries(16));
}

TEST(GridDissection, PiecesHoldEveryNodeOnce) {
    for_parts([](const OnGrid& part) {
        for (int leaf : {1, 8, 1000}) {
            const DissectedNodes d = dissected({part.hints.place, part.hints.reach}, leaf);
            std::vector<int> seen = d.order;
            std::sort(seen.begin(), seen.end());
            ASSERT_EQ(seen.size(), part.hints.place.size());
            for (std::size_t k = 0; k < seen.size(); ++k) ASSERT_EQ(seen[k], static_cast<int>(k));
            EXPECT_EQ(d.first.back(), static_cast<int>(seen.size()));
            for (std::size_t k = 0; k + 1 < d.first.size(); ++k) EXPECT_LT(d.first[k], d.first[k + 1]);
        }
    });
}

TEST(LargePages, BeginAsZero) {
    for (std::size_t n : {std::size_t{0}, std::size_t{10}, std::size_t{3} << 20})
        for (int again = 0; again < 2; ++again) {
            const Numbers numbers = zeros(n);
            EXPECT_TRUE(std::all_of(numbers.get(), numbers.get() + n, [](double v) { return v == 0; }));
            std::fill(numbers.get(), numbers.get() + n, 1.0);
        }
}

}  // namespace abut::solver::frontal_factor_test
