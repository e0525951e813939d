#pragma once

#include <boost/program_options.hpp>
#include <string>

#include "common/drawing/page_style.hpp"

namespace rockslope::tool_support {

/// Adds --width, --font and --font-size, which every picture of a program obeys.
void add_picture_options(boost::program_options::options_description& options);

/// The style that these options ask for. @param program name that an error begins with; empty: none.
/// @throws InputError.
PageStyle picture_style(const boost::program_options::variables_map& values, const std::string& program);

}  // namespace rockslope::tool_support
