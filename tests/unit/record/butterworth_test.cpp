#include "record/butterworth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "record/accelerogram.hpp"

namespace rockslope::record::butterworth_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double step = 0.01;

/// The record of reference/zero_phase.py.
std::vector<double> reference_record() {
    std::vector<double> record;
    const double waves[][2] = {{0.4, 0.3}, {1.7, 1.0}, {5.3, 0.6}, {20.0, 0.2}};
    for (int k = 0; k < 1200; ++k) {
        const double t = step * k;
        double value = 0.02 + 0.003 * t + 0.05 * std::sin(2 * pi * 0.03 * t);
        for (const auto& [frequency, amplitude] : waves)
            value += amplitude * std::exp(-std::pow((t - 5) / 3, 2)) *
                     std::sin(2 * pi * frequency * t + frequency);
        record.push_back(value);
    }
    return record;
}

struct FilterCase {
    Pass pass;
    int order;
    double corner;
    int extension;
};

/// SciPy's default extension: three times the number of filter coefficients.
std::size_t extension_of(const FilterCase& tested) {
    return tested.extension < 0 ? 3 * (static_cast<std::size_t>(tested.order) + 1)
                                : static_cast<std::size_t>(tested.extension);
}

// The tolerance is 1e-9 for values up to 2; the file has thirteen digits of SciPy's result.
TEST(Butterworth, AgreesWithTheZeroPhaseFilterOfSciPy) {
    std::ifstream file(std::filesystem::path(REFERENCE_FOLDER) / "zero_phase.csv");
    const FilterCase cases[] = {{Pass::high, 2, 0.1, 0},  {Pass::high, 4, 0.05, 0}, {Pass::high, 4, 0.2, -1},
                                {Pass::high, 3, 0.1, -1}, {Pass::low, 8, 20.0, -1}, {Pass::high, 1, 0.5, -1}};
    const std::vector<double> record = reference_record();
    std::vector<std::vector<double>> ours;
    for (const FilterCase& tested : cases)
        ours.push_back(filter_both_ways(butterworth(tested.pass, tested.order, tested.corner, step), record,
                                        extension_of(tested)));
    std::string line;
    std::getline(file, line);
    int rows = 0;
    for (; std::getline(file, line); ++rows) {
        std::istringstream fields(line);
        std::string field;
        std::getline(fields, field, ',');
        const std::size_t k = std::stoul(field);
        for (const std::vector<double>& column : ours) {
            ASSERT_TRUE(std::getline(fields, field, ','));
            EXPECT_NEAR(column[k], std::stod(field), 1e-9) << "sample " << k;
        }
    }
    EXPECT_EQ(rows, 172);
}

// By the definition of the corner frequency one pass keeps 1 / sqrt(2) of the amplitude, and two passes keep
// half, without delay.
TEST(Butterworth, KeepsHalfAtItsCornerInTwoPasses) {
    for (const Pass pass : {Pass::low, Pass::high}) {
        for (const int order : {1, 2, 3, 4, 8}) {
            std::vector<double> sine;
            for (int k = 0; k <= 6000; ++k) sine.push_back(std::sin(2 * pi * 2 * step * k));
            const std::vector<double> kept = filter_both_ways(butterworth(pass, order, 2, step), sine, 0);
            for (int k = 2500; k < 3500; ++k) EXPECT_NEAR(kept[k], sine[k] / 2, 1e-6);
        }
    }
}

TEST(Butterworth, RejectsInvalidCornersAndOrders) {
    EXPECT_THROW(butterworth(Pass::high, 0, 1, step), std::invalid_argument);
    EXPECT_THROW(butterworth(Pass::high, 13, 1, step), std::invalid_argument);
    EXPECT_THROW(butterworth(Pass::high, 4, 0, step), std::invalid_argument);
    EXPECT_THROW(butterworth(Pass::high, 4, 50, step), std::invalid_argument);
    EXPECT_THROW(butterworth(Pass::high, 4, std::nan(""), step), std::invalid_argument);
    EXPECT_THROW(filter_both_ways(butterworth(Pass::high, 4, 1, step), {1, 2}, 2), std::invalid_argument);
}

}  // namespace
}  // namespace rockslope::record::butterworth_test
