#include "parse_subcommand.hpp"

#include <stdexcept>

#include "support/command_page.hpp"
#include "support/parse_arguments.hpp"

namespace rockslope {

namespace po = boost::program_options;

namespace {

tool_support::CommandPage page_of(const std::string& usage, const po::options_description& options) {
    const std::size_t name_end = usage.find(' '), line_end = usage.find('\n');
    tool_support::CommandPage page{.name = "ground-motion " + usage.substr(0, name_end),
                                   .version = ROCKSLOPE_VERSION,
                                   .synopsis = usage.substr(name_end + 1, line_end - name_end - 1),
                                   .purpose = usage.substr(line_end + 1),
                                   .description = ""};
    for (const auto& option : options.options()) page.options.add(option);
    page.options.add_options()("help,h", "print this text and stop");
    return page;
}

}  // namespace

std::optional<po::variables_map> parse_subcommand(const std::string& usage,
                                                  const std::vector<std::string>& arguments,
                                                  const po::options_description& options) {
    const tool_support::CommandPage page = page_of(usage, options);
    const std::optional<int> printed = tool_support::print_requested_text(page, arguments);
    if (printed && *printed != 0) throw std::runtime_error("the help text cannot be printed");
    if (printed) return std::nullopt;
    return tool_support::parse_arguments("", arguments, page.options);
}

std::vector<std::string> files_of(const po::variables_map& values) {
    return values.count("file") ? values["file"].as<std::vector<std::string>>() : std::vector<std::string>{};
}

}  // namespace rockslope
