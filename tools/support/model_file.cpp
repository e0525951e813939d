#include "support/model_file.hpp"

#include <vector>

#include "common/base/input_error.hpp"

namespace rockslope::tool_support {

std::string model_file_of(const char* program, const boost::program_options::variables_map& values,
                          const std::string& usage) {
    const auto files =
        values.count("file") ? values["file"].as<std::vector<std::string>>() : std::vector<std::string>{};
    if (files.size() == 1) return files.front();
    throw InputError({program},
                     files.empty() ? "no model file is given" : "more than one model file is given",
                     usage + "; --help lists the options, --template prints a model file");
}

}  // namespace rockslope::tool_support
