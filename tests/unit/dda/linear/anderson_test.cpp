#include "dda/linear/anderson.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "support/case_name.hpp"

namespace rockslope::anderson_test {
namespace {

/// g(x) = A x + b and its fixed point.
struct Affine {
    Eigen::MatrixXd a;
    Eigen::VectorXd b;
    Eigen::VectorXd operator()(const Eigen::VectorXd& x) const { return a * x + b; }
    Eigen::VectorXd fixed_point() const {
        return (Eigen::MatrixXd::Identity(a.rows(), a.cols()) - a).partialPivLu().solve(b);
    }
};

Affine random_map(int size, double norm, unsigned seed) {
    std::mt19937 engine(seed);
    const auto draw = [&] { return static_cast<double>(engine()) / 4294967296.0 * 2 - 1; };
    Affine map{Eigen::MatrixXd(size, size), Eigen::VectorXd(size)};
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) map.a(i, j) = draw();
        map.b[i] = draw();
    }
    map.a *= norm / map.a.norm();
    return map;
}

/// Relative error after `steps` mixed iterations from zero.
double error_after(const Affine& map, int memory, int steps) {
    dda::AndersonMixing mixing(memory);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(map.b.size());
    for (int k = 0; k < steps; ++k) x = mixing.next(x, map(x));
    return (x - map.fixed_point()).norm() / (1 + map.fixed_point().norm());
}

class AndersonOnAffineMaps : public testing::TestWithParam<std::tuple<int, double>> {};

// n residual differences span the space of n unknowns, so the (n + 1)th iterate is the fixed point, whether
// plain iteration converges (norm below 1) or diverges. Rounding is amplified by the condition number of the
// differences; 1e-6 leaves room for it.
TEST_P(AndersonOnAffineMaps, ConvergeInOneStepMoreThanUnknowns) {
    const auto [size, norm] = GetParam();
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Affine map = random_map(size, norm, seed);
        EXPECT_LT(error_after(map, size, size + 1), 1e-6)
            << size << " unknowns, norm " << norm << ", seed " << seed;
        if (size > 1) {
            EXPECT_GT(error_after(map, size, size - 1), 1e-6)
                << "converged too early: the test shows nothing";
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Sizes, AndersonOnAffineMaps,
                         testing::Combine(testing::Values(1, 2, 4, 6), testing::Values(0.5, 0.9, 3.0, 10.0)),
                         [](const auto& tested) {
                             return case_name("size " + case_number(std::get<0>(tested.param)) + " norm " +
                                              case_number(std::get<1>(tested.param)));
                         });

TEST(AndersonMixing, WithoutMemoryIsPlainIteration) {
    const Affine map = random_map(3, .5, 1);
    for (const int memory : {0, -1}) {
        dda::AndersonMixing mixing(memory);
        Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
        for (int k = 0; k < 4; ++k) {
            const Eigen::VectorXd next = mixing.next(x, map(x));
            EXPECT_EQ(next, map(x)) << "memory " << memory << ", iterate " << k;
            x = next;
        }
    }
}

TEST(AndersonMixing, FirstStepIsPlainIteration) {
    dda::AndersonMixing mixing(3);
    const Eigen::Vector2d image(3, 4);
    EXPECT_EQ(mixing.next(Eigen::Vector2d(1, 2), image), image);
}

TEST(AndersonMixing, AtAFixedPointStaysThere) {
    dda::AndersonMixing mixing(3);
    const Eigen::Vector2d x(1, 2);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(mixing.next(x, x), x);
}

TEST(AndersonMixing, AcceptsEmptyVectors) {
    dda::AndersonMixing mixing(3);
    const Eigen::VectorXd none(0);
    EXPECT_EQ(mixing.next(none, none).size(), 0);
    EXPECT_EQ(mixing.next(none, none).size(), 0);
}

}  // namespace
}  // namespace rockslope::anderson_test
