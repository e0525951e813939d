#include <iostream>
#include <stdexcept>

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"
#include "common/base/text.hpp"
#include "record_commands.hpp"
#include "support/command_page.hpp"
#include "support/standard_streams.hpp"

using namespace rockslope;

namespace {

tool_support::CommandPage command_page() {
    tool_support::CommandPage page{.name = "ground-motion",
                                   .version = ROCKSLOPE_VERSION,
                                   .synopsis = "SUBCOMMAND [options]",
                                   .purpose = "Shows, changes, compares and makes accelerograms",
                                   .description = ""};
    for (const RecordCommand& command : record_commands())
        page.subcommands.push_back({command.name, command.purpose});
    auto add = page.options.add_options();
    add("version", "print the version and stop");
    add("help,h", "print this text and stop");
    return page;
}

int refuse(const std::string& message) {
    std::cerr << "ground-motion: " << message << '\n';
    return 2;
}

/// Refuses a subcommand, with the nearest one if there is one.
int refuse_command(const std::string& word) {
    std::vector<std::string> names;
    for (const RecordCommand& command : record_commands()) names.emplace_back(command.name);
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    const auto nearest = nearest_word(word, names);
    return refuse("unknown subcommand '" + word + "'" +
                  (nearest ? "; did you mean '" + *nearest + "'?" : "; expected: " + known));
}

int run(const std::vector<std::string>& arguments) {
    const std::string command = arguments.empty() ? "" : arguments.front();
    for (const RecordCommand& known : record_commands())
        if (command == known.name) return known.run({arguments.begin() + 1, arguments.end()});
    if (const auto code = tool_support::print_requested_text(command_page(), arguments)) return *code;
    return refuse_command(command);
}

/// Does what the arguments ask for; prints why it failed. @return the exit code.
int act_on_arguments(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const std::invalid_argument& error) {
        return refuse(error.what());
    } catch (const InputError& error) {
        return refuse(error.what());
    } catch (const OutputError& error) {
        return refuse(error.what());
    } catch (const std::exception& error) {
        std::cerr << "ground-motion: " << error.what() << '\n';
        return 1;
    }
}

}  // namespace

int main(int argc, char** argv) {
    return tool_support::run_program("ground-motion", [&] { return act_on_arguments(argc, argv); });
}
