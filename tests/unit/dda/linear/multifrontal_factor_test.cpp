#include "dda/linear/multifrontal_factor.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "dda/linear/linear_solver.hpp"
#include "support/step_system.hpp"
#include "support/walls.hpp"
#include "unit/dda/linear/random_systems.hpp"

namespace rockslope::multifrontal_factor_test {
namespace {

using dda::BlockPattern;
using dda::Front;
using dda::SymbolicFactor;
using dda::Vec6;

// No other front writes to an update from the moment it is formed until its parent has added it. Inside a
// subtree each thread has its own space. All subtree roots come before the fronts above them.
TEST(SymbolicFactor, UpdatesDoNotOverlapWhileTheyAreNeeded) {
    for (const int columns : {1, 4, 15, 30}) {
        const auto pattern = BlockPattern::from_pairs(columns * 20, grid_graph(columns, 20));
        const SymbolicFactor plan = dda::symbolic_factorization(pattern, tree_of(pattern), 8, 0);
        EXPECT_FALSE(plan.keeps_updates);
        const int count = static_cast<int>(plan.count());
        const auto front = [&](int f) -> const Front& { return plan.fronts[f]; };
        const auto size = [&](const Front& f) {
            const auto rows = static_cast<std::size_t>(f.rows);
            return 6 * (rows * f.stride - dda::omitted_rows_before(rows, 8));
        };
        std::vector<int> subtree(plan.count(), -1);
        for (const dda::Subtree& one : plan.subtrees) {
            for (int f = one.begin; f < one.end; ++f) subtree[f] = one.begin;
            for (int f = one.begin; f < one.end; ++f) EXPECT_EQ(front(f).in_subtree, f + 1 < one.end);
        }
        for (int a = 0; a < count; ++a) {
            const bool inside = front(a).in_subtree;
            EXPECT_LE(front(a).update + size(front(a)), inside ? plan.subtree_space : plan.shared_space);
            EXPECT_TRUE(subtree[a] >= 0 ||
                        std::binary_search(plan.top_fronts.begin(), plan.top_fronts.end(), a));
            for (int b = 0; b < count; ++b) {
                if (a == b || front(b).in_subtree != inside) continue;
                const bool a_is_root = !inside && subtree[a] >= 0;
                const bool b_is_root = !inside && subtree[b] >= 0;
                if (inside && subtree[a] != subtree[b]) continue;
                const bool b_comes_while_a_is_needed =
                    (a_is_root && b_is_root) || ((a_is_root || a < b) && !b_is_root && b <= front(a).parent);
                const bool apart = front(a).update + size(front(a)) <= front(b).update ||
                                   front(b).update + size(front(b)) <= front(a).update;
                EXPECT_TRUE(apart || !b_comes_while_a_is_needed) << a << " and " << b;
            }
        }
    }
}

// Each unit is a subtree inside one of `subtrees`. The updates of its inner fronts are used inside the unit
// only. All other updates keep their own memory.
TEST(SymbolicFactor, AllocatesTheUpdateOfEachUnit) {
    const auto pattern = BlockPattern::from_pairs(30 * 40, grid_graph(30, 40));
    const SymbolicFactor plan = dda::symbolic_factorization(pattern, tree_of(pattern), 8);
    ASSERT_TRUE(plan.keeps_updates);
    EXPECT_GT(plan.refactor_units.size(), plan.subtrees.size());
    const auto front = [&](int f) -> const Front& { return plan.fronts[f]; };
    std::vector<char> is_inner(plan.count(), 0);
    for (const dda::Subtree& unit : plan.refactor_units) {
        EXPECT_TRUE(std::any_of(plan.subtrees.begin(), plan.subtrees.end(), [&](const dda::Subtree& subtree) {
            return subtree.begin <= unit.begin && unit.end <= subtree.end;
        }));
        for (int f = unit.begin; f + 1 < unit.end; ++f) {
            is_inner[f] = 1;
            EXPECT_LT(front(f).parent, unit.end);
        }
    }
    std::size_t end = 0;
    for (std::size_t f = 0; f < plan.count(); ++f) {
        const Front& one = plan.fronts[f];
        EXPECT_EQ(one.in_subtree, is_inner[f] != 0);
        if (one.in_subtree) continue;
        const auto rows = static_cast<std::size_t>(one.rows);
        EXPECT_GE(one.update, end);
        end = one.update + 6 * (rows * one.stride - dda::omitted_rows_before(rows, 8));
    }
    EXPECT_EQ(end, plan.shared_space);
}

TEST(SymbolicFactor, StoresTheLowerTriangleOfAnUpdate) {
    for (const std::size_t w : {8, 16}) {
        for (const std::size_t rows : {1, 2, 5, 9, 40}) {
            const std::size_t stride = (6 * rows + w - 1) / w * w;
            std::size_t end = 0;  // of the block columns before j
            for (std::size_t j = 0; j < rows; ++j) {
                const std::size_t first = dda::first_update_row(j, w);
                EXPECT_LE(first, 6 * j);
                EXPECT_GT(first + w, 6 * j);
                EXPECT_EQ(dda::update_column_offset(j, stride, w) + first, end);
                EXPECT_EQ(dda::update_column_stride(j, stride, w), stride - first);
                end += 6 * (stride - first);
            }
            EXPECT_EQ(end, 6 * (rows * stride - dda::omitted_rows_before(rows, w)));
        }
    }
}

template <class Scalar>
std::vector<Vec6> solution(const scene::StepSystem& system, int threads) {
    const ThreadPool pool(threads);
    dda::MultifrontalFactor<Scalar> factor;
    factor.analyze(system.pattern, tree_of(system.pattern));
    EXPECT_TRUE(factor.factorize(system.matrix, pool));
    std::vector<Vec6> x = system.load;
    factor.solve(x, pool);
    return x;
}

/// Large enough for several subtrees and for fronts whose work is split among threads.
scene::StepSystem large_system() {
    return scene::step_system(scene::running_bond_wall(40, 40, 10).model, 0.005);
}

TEST(MultifrontalFactor, IsTheSameBytesOnOneThreadAndTwo) {
    const scene::StepSystem system = large_system();
    EXPECT_EQ(solution<double>(system, 1), solution<double>(system, 2));
    EXPECT_EQ(solution<float>(system, 1), solution<float>(system, 2));
}

TEST(MultifrontalFactor, SolvesToTheSameBytesOnAnyNumberOfThreads) {
    const scene::StepSystem system = scene::step_system(scene::running_bond_wall(50, 50, 10).model, 0.005);
    dda::MultifrontalFactor<double> factor;
    factor.analyze(system.pattern, tree_of(system.pattern));
    ASSERT_GT(factor.symbolic().factor_size, dda::min_parallel_factor_size);
    ASSERT_TRUE(factor.factorize(system.matrix, ThreadPool(1)));
    std::vector<Vec6> expected = system.load;
    factor.solve(expected);
    for (const int threads : {2, 3}) {
        const ThreadPool pool(threads);
        for (int k = 0; k < 5; ++k) {
            std::vector<Vec6> x = system.load;
            factor.solve(x, pool);
            EXPECT_EQ(x, expected) << threads << " threads";
        }
    }
}

/// The wall with some of its contacts open.
scene::StepSystem with_open(const std::vector<std::size_t>& contacts) {
    return scene::step_system(scene::running_bond_wall(40, 40, 10).model, 0.005, [&](std::size_t k) {
        return std::find(contacts.begin(), contacts.end(), k) != contacts.end();
    });
}

std::vector<char> changed_rows(const dda::BlockMatrix& a, const dda::BlockMatrix& b) {
    std::vector<char> differ(a.diagonal.size(), 0);
    for (std::size_t i = 0; i < differ.size(); ++i) differ[i] = a.diagonal[i] == b.diagonal[i] ? 0 : 1;
    return differ;
}

// Contacts open and close at random, a few or a fifth of them. A refactorisation must give the same bytes as
// a full factorisation. Without kept updates everything is factorised, to the same bytes.
TEST(MultifrontalFactor, RefactorizationEqualsAFullFactorization) {
    RandomNumbers draw(11);
    const scene::StepSystem whole = large_system();
    for (const int threads : {1, 2}) {
        const ThreadPool pool(threads);
        dda::MultifrontalFactor<double> kept;
        dda::MultifrontalFactor<double> not_kept;
        kept.analyze(whole.pattern, tree_of(whole.pattern));
        not_kept.analyze(whole.pattern, tree_of(whole.pattern), 0);
        EXPECT_TRUE(kept.symbolic().keeps_updates);
        ASSERT_TRUE(kept.factorize(whole.matrix, pool));
        ASSERT_TRUE(not_kept.factorize(whole.matrix, pool));
        scene::StepSystem last = whole;
        for (const int count : {1, 3, 1500, 20, 0}) {
            std::vector<std::size_t> open;
            for (int k = 0; k < count; ++k) open.push_back(static_cast<std::size_t>(draw.below(6000)));
            scene::StepSystem now = with_open(open);
            const std::vector<char> changed = changed_rows(last.matrix, now.matrix);
            EXPECT_GT(std::count(changed.begin(), changed.end(), 1), 0);
            ASSERT_TRUE(kept.factorize(now.matrix, pool, changed));
            ASSERT_TRUE(not_kept.factorize(now.matrix, pool, changed));
            std::vector<Vec6> x = now.load;
            std::vector<Vec6> y = now.load;
            kept.solve(x);
            not_kept.solve(y);
            EXPECT_EQ(x, solution<double>(now, 1)) << count << " open";
            EXPECT_EQ(x, y) << count << " open";
            last = std::move(now);
        }
    }
}

// With no row marked as changed it does nothing, even if the matrix differs.
TEST(MultifrontalFactor, RefactorizesOnlyChangedFronts) {
    scene::StepSystem system = large_system();
    const ThreadPool pool(1);
    dda::MultifrontalFactor<double> factor;
    factor.analyze(system.pattern, tree_of(system.pattern));
    ASSERT_TRUE(factor.factorize(system.matrix, pool));
    std::vector<Vec6> before = system.load;
    factor.solve(before);
    for (dda::Mat6& diagonal : system.matrix.diagonal) diagonal *= 2;
    ASSERT_TRUE(factor.factorize(system.matrix, pool, std::vector<char>(system.matrix.diagonal.size(), 0)));
    std::vector<Vec6> after = system.load;
    factor.solve(after);
    EXPECT_EQ(before, after);
}

TEST(MultifrontalFactor, RecoversAfterAnIndefiniteMatrix) {
    const scene::StepSystem system = large_system();
    const ThreadPool pool(1);
    dda::MultifrontalFactor<double> factor;
    factor.analyze(system.pattern, tree_of(system.pattern));
    ASSERT_TRUE(factor.factorize(system.matrix, pool));
    dda::BlockMatrix spoiled = system.matrix;
    spoiled.diagonal[7] = -spoiled.diagonal[7];
    std::vector<char> changed = changed_rows(spoiled, system.matrix);
    EXPECT_FALSE(factor.factorize(spoiled, pool, changed));
    ASSERT_TRUE(factor.factorize(system.matrix, pool, changed));
    std::vector<Vec6> x = system.load;
    factor.solve(x);
    EXPECT_EQ(x, solution<double>(system, 1));
}

/// |a - b| / |b|.
double relative_difference(const std::vector<Vec6>& a, const std::vector<Vec6>& b) {
    double difference = 0;
    double size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference += (a[i] - b[i]).squaredNorm();
        size += b[i].squaredNorm();
    }
    return std::sqrt(difference / size);
}

// The condition number of the wall is some 1e4 (springs of 10 E, 5 ms), so the error is up to 1e-11 in double
// precision and 1e-2 in single.
TEST(MultifrontalFactor, SolvesAWallAsEigenDoes) {
    const scene::StepSystem system = large_system();
    const auto simplicial = dda::make_simplicial_solver();
    simplicial->analyze(system.pattern);
    ASSERT_TRUE(simplicial->factorize(system.matrix));
    std::vector<Vec6> expected = system.load;
    simplicial->solve(expected);
    EXPECT_LT(relative_difference(solution<double>(system, 1), expected), 1e-11);
    EXPECT_LT(relative_difference(solution<float>(system, 1), expected), 1e-2);
}

TEST(MultifrontalFactor, RejectsNan) {
    RandomSystem system(20, 40, 3);
    const ThreadPool pool(1);
    dda::MultifrontalFactor<double> factor;
    factor.analyze(system.pattern, tree_of(system.pattern));
    system.matrix.diagonal[7](4, 2) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(factor.factorize(system.matrix, pool));
}

TEST(MultifrontalFactor, SinglePrecisionFailsOnANearlySingularMatrix) {
    // A mass of 1e-12 vanishes beside springs of 1 in single precision.
    const RandomSystem system(6, 4, 2, 1e-12);
    const ThreadPool pool(1);
    dda::MultifrontalFactor<double> wide;
    wide.analyze(system.pattern, tree_of(system.pattern));
    EXPECT_TRUE(wide.factorize(system.matrix, pool));
    dda::MultifrontalFactor<float> narrow;
    narrow.analyze(system.pattern, tree_of(system.pattern));
    EXPECT_FALSE(narrow.factorize(system.matrix, pool));
}

}  // namespace
}  // namespace rockslope::multifrontal_factor_test
