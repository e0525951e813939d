#pragma once

#include <string>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// The record as a PEER AT2 file: four header lines, of which `heading` is the first and `title` the second,
/// then the acceleration in g, five values to a line, eight significant digits.
std::string at2_text(const Accelerogram& record, const std::string& title,
                     const std::string& heading = "SYNTHETIC STRONG MOTION RECORD");

/// The record as two columns, time in s and acceleration in m/s2, after `title` as a comment and a heading.
/// Every number reads back as the same double.
std::string csv_text(const Accelerogram& record, const std::string& title);

}  // namespace rockslope::record
