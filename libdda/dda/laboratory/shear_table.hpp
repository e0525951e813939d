#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dda/joint/shear_test.hpp"

namespace rockslope::dda {

/// Measured or computed points of a shear test, SI units. Columns that were not in the file are empty.
struct ShearTable {
    std::vector<double> displacement;   ///< m
    std::vector<double> shear_stress;   ///< Pa
    std::vector<double> dilation;       ///< m
    std::vector<double> normal_stress;  ///< Pa
};

/// Reads a CSV table, separated by commas or semicolons. Lines that begin with # are skipped. The first other
/// line is a heading of names with units, such as "displacement (mm),shear stress (MPa),dilation (mm),normal
/// stress (kPa)". The column `displacement` is required; unknown columns are skipped.
/// @throws InputError with file and line.
ShearTable read_shear_table(const std::filesystem::path& file);
/// Reads the columns of a measured joint from a run's joints.csv, starting where displacements were last
/// zeroed, which is the second of two rows with the same time.
ShearTable read_measured_joint(const std::filesystem::path& file, const std::string& joint);

/// The rows as CSV, with a heading that read_shear_table accepts.
std::string shear_rows_csv(const std::vector<ShearTestRow>& rows);

/// Difference between computed and measured values, in their unit.
struct Misfit {
    double root_mean_square = 0;
    double largest = 0;  ///< magnitude
    double at = 0;       ///< m, displacement of the largest difference
};

/// A test run along the displacements of a table, and along its normal stresses where they are prescribed,
/// and its misfit to each column of the table.
struct Comparison {
    std::vector<ShearTestRow> rows;  ///< one per point of the table
    std::optional<Misfit> shear_stress, dilation, normal_stress;
};
/// @pre `measured` has normal stresses if `test` prescribes them.
Comparison compare(ShearTest test, const ShearTable& measured);

}  // namespace rockslope::dda
