#pragma once

#include <boost/program_options.hpp>

namespace rockslope::tool_support {

/// The words of a command line by option; what belongs to none is listed, as strings, under "file". Options
/// are not guessed from their beginnings. @throws InputError with one line that begins with the
/// program's name.
boost::program_options::variables_map parse_arguments(
    const char* program, int argc, const char* const* argv,
    const boost::program_options::options_description& options);

}  // namespace rockslope::tool_support
