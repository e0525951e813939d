#pragma once

#include <string>

namespace rockslope::tool_support {

/// The commit of the sources that the programs were built from, shortened, with "-dirty" where files had been
/// changed since; "unknown" outside a repository.
std::string commit();

}  // namespace rockslope::tool_support
