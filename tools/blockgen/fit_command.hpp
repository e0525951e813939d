#pragma once

#include <string>
#include <vector>

namespace rockslope::blockgen_tool {

/// What `blockgen fit` does, for the page of blockgen.
inline constexpr const char* fit_purpose =
    "Estimates joint sets, trace lengths, spacing and intensity from a map and writes a slope model";

/// Runs `blockgen fit`. @param arguments those after "fit". @return the exit code. @throws InputError,
/// UsageError or OutputError.
int run_fit(const std::vector<std::string>& arguments);

}  // namespace rockslope::blockgen_tool
