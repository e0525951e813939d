#pragma once

#include <string>

#include "common/base/function_ref.hpp"

namespace rockslope::tool_support {

/// The main function of a program. Takes the numbers of standard streams that are closed, so that no file of
/// results gets one of them, and a closed pipe for an error of writing instead of a signal that kills.
/// @param body does everything and returns the exit code.
/// @return that code; 1 where it is 0 and the standard output could not be written, after saying so.
int run_program(const std::string& program, FunctionRef<int()> body);

}  // namespace rockslope::tool_support
