#include <boost/program_options/errors.hpp>
#include <iostream>
#include <stdexcept>

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"
#include "record_commands.hpp"

using namespace rockslope;

namespace {

std::string usage() {
    std::string text =
        "ground-motion SUBCOMMAND [options]\n"
        "  synthesise     make an artificial accelerogram\n";
    for (const RecordCommand& command : record_commands()) {
        const std::string name = command.name;
        text += "  " + name + std::string(15 - name.size(), ' ') + command.purpose + "\n";
    }
    return text + "ground-motion SUBCOMMAND --help lists the options.\n";
}

std::string known_commands() {
    std::string text = "synthesise";
    for (const RecordCommand& command : record_commands()) text += std::string(", ") + command.name;
    return text;
}

int refuse(const std::string& message) {
    std::cerr << "ground-motion: " << message << '\n';
    return 2;
}

int run(const std::vector<std::string>& arguments) {
    const std::string command = arguments.empty() ? "" : arguments.front();
    if (command == "--help" || command == "-h") {
        std::cout << usage();
        return 0;
    }
    if (command == "--version") {
        std::cout << "ground-motion " ROCKSLOPE_VERSION "\n";
        return 0;
    }
    const std::vector<std::string> rest(arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end());
    if (command == "synthesise") return run_synthesise(rest);
    for (const RecordCommand& known : record_commands())
        if (command == known.name) return known.run(rest);
    return refuse("unknown subcommand '" + command + "'; expected: " + known_commands());
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const boost::program_options::error& error) {
        return refuse(error.what());
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
