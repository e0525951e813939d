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

/// Reads a CSV table: apart by commas or semicolons, lines that begin with # skipped, the first other line a
/// heading of names with units, such as "displacement (mm),shear stress (MPa),dilation (mm),normal stress
/// (kPa)". `displacement` must be there; other columns are skipped. @throws InputError with file:line.
ShearTable read_shear_table(const std::filesystem::path& file);
/// The columns of one measured joint in a run's joints.csv, from where displacements last began to count
/// anew: the second of two rows of one time.
ShearTable read_measured_joint(const std::filesystem::path& file, const std::string& joint);

/// The rows as CSV, with a heading that read_shear_table reads.
std::string shear_rows_csv(const std::vector<ShearTestRow>& rows);

/// How far computed values are from measured ones.
struct Misfit {
    double root_mean_square = 0;
    double largest = 0;  ///< magnitude
    double at = 0;       ///< m, displacement where it is
};

/// A test driven along the displacements of a table, and its differences from the columns that the table has.
struct Comparison {
    std::vector<ShearTestRow> rows;  ///< one for each point of the table
    std::optional<Misfit> shear_stress, dilation, normal_stress;
};
Comparison compare(ShearTest test, const ShearTable& measured);

}  // namespace rockslope::dda
