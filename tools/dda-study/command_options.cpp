#include "command_options.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/base/input_error.hpp"
#include "support/command_page.hpp"
#include "support/parse_arguments.hpp"

namespace rockslope {

CommandOptions::CommandOptions(std::string synopsis, std::string purpose)
    : synopsis_(std::move(synopsis)), purpose_(std::move(purpose)), options_("Options") {
    options_.add_options()("help,h", "print this text and stop");
}

std::string CommandOptions::program() const {
    return "dda-study " + synopsis_.substr(0, synopsis_.find(' '));
}

bool CommandOptions::parse(const std::vector<std::string>& arguments) {
    tool_support::CommandPage page{
        .name = program(),
        .version = ROCKSLOPE_VERSION,
        .synopsis = synopsis_.substr(std::min(synopsis_.find(' ') + 1, synopsis_.size())),
        .purpose = purpose_.substr(0, purpose_.find_last_not_of(". ") + 1),
        .description = ""};
    for (const auto& option : options_.options()) page.options.add(option);
    const std::optional<int> printed = tool_support::print_requested_text(page, arguments);
    if (printed && *printed != 0) throw std::runtime_error("the help text cannot be printed");
    if (printed) return false;
    values_ = tool_support::parse_arguments(program(), arguments, options_);
    return true;
}

std::vector<std::string> CommandOptions::arguments() const {
    return has("file") ? get<std::vector<std::string>>("file") : std::vector<std::string>{};
}

std::string CommandOptions::argument(const std::string& what) const {
    const std::vector<std::string> all = arguments();
    if (all.size() == 1 && !all.front().empty()) return all.front();
    throw InputError({program()}, all.size() > 1 ? "there is more than one argument" : what + " is not given",
                     "dda-study " + synopsis_);
}

std::optional<std::filesystem::path> CommandOptions::path(const char* name) const {
    if (!has(name)) return std::nullopt;
    if (get<std::string>(name).empty())
        throw InputError({program()}, std::string("--") + name + " is empty", "a path");
    return get<std::string>(name);
}

std::string CommandOptions::required(const char* name, const std::string& expected) const {
    if (!has(name) || get<std::string>(name).empty())
        throw InputError({program()}, std::string("--") + name + " is not given", expected);
    return get<std::string>(name);
}

}  // namespace rockslope
