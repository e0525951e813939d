#include "support/parse_arguments.hpp"

#include <string>
#include <vector>

#include "common/base/input_error.hpp"

namespace rockslope::tool_support {

namespace po = boost::program_options;

po::variables_map parse_arguments(const char* program, int argc, const char* const* argv,
                                  const po::options_description& options) {
    po::options_description all;
    all.add(options).add_options()("file", po::value<std::vector<std::string>>());
    po::positional_options_description positional;
    positional.add("file", -1);
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::variables_map values;
    try {
        po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
                  values);
        po::notify(values);
    } catch (const po::error& error) {
        throw InputError({program}, error.what(), "the options that --help lists");
    }
    return values;
}

std::string model_file_of(const char* program, const po::variables_map& values, const std::string& usage) {
    const auto files =
        values.count("file") ? values["file"].as<std::vector<std::string>>() : std::vector<std::string>{};
    if (files.size() == 1) return files.front();
    throw InputError({program},
                     files.empty() ? "no model file is given" : "more than one model file is given",
                     usage + "; --help lists the options, --template prints a model file");
}

}  // namespace rockslope::tool_support
