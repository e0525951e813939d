#pragma once

#include <string>

#include "blockgen/picture/canvas.hpp"
#include "dda/record/accelerogram.hpp"

/// Acceleration (g), velocity (m/s) and displacement (m) of a record against time, beside its 5 % response
/// spectrum up to 4 s.
blockgen::Canvas record_picture(const dda::Accelerogram& record, const std::string& title);
