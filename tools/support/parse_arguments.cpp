#include "support/parse_arguments.hpp"

#include <algorithm>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"

namespace rockslope::tool_support {

namespace po = boost::program_options;

namespace {

/// "; did you mean '--output'?", or nothing when no option is near.
std::string suggestion(const po::unknown_option& error, const po::options_description& options) {
    std::vector<std::string> names;
    for (const auto& option : options.options()) names.push_back(option->long_name());
    const std::string word = error.get_option_name();
    const auto nearest = nearest_word(word.substr(std::min(word.find_first_not_of('-'), word.size())), names);
    return nearest ? "; did you mean '--" + *nearest + "'?" : "";
}

}  // namespace

po::variables_map parse_arguments(const std::string& program, const std::vector<std::string>& arguments,
                                  const po::options_description& options) {
    po::options_description all;
    all.add(options).add_options()("file", po::value<std::vector<std::string>>());
    po::positional_options_description positional;
    positional.add("file", -1);
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::variables_map values;
    try {
        po::store(po::command_line_parser(arguments).options(all).positional(positional).style(style).run(),
                  values);
        po::notify(values);
    } catch (const po::unknown_option& error) {
        const std::string nearest = suggestion(error, options);
        throw InputError({program}, error.what() + nearest,
                         nearest.empty() ? "the options that --help lists" : "");
    } catch (const po::error& error) {
        throw InputError({program}, error.what(), "the options that --help lists");
    }
    return values;
}

po::variables_map parse_arguments(const char* program, int argc, const char* const* argv,
                                  const po::options_description& options) {
    return parse_arguments(program, arguments_of(argc, argv), options);
}

std::vector<std::string> arguments_of(int argc, const char* const* argv) {
    return {argv + std::min(argc, 1), argv + argc};
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
