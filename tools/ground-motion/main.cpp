#include <boost/program_options/errors.hpp>
#include <iostream>
#include <stdexcept>

#include "blockgen/base/input_error.hpp"
#include "blockgen/base/output_error.hpp"
#include "synthesise_command.hpp"

namespace {

constexpr const char* usage =
    "ground-motion SUBCOMMAND [options]\n"
    "  synthesise   make an artificial accelerogram\n"
    "ground-motion SUBCOMMAND --help tells the options.\n";

int refuse(const std::string& message) {
    std::cerr << "ground-motion: " << message << '\n';
    return 2;
}

int run(const std::vector<std::string>& arguments) {
    const std::string command = arguments.empty() ? "" : arguments.front();
    if (command == "--help" || command == "-h") {
        std::cout << usage;
        return 0;
    }
    if (command == "--version") {
        std::cout << "ground-motion " ROCKSLOPE_VERSION "\n";
        return 0;
    }
    if (command != "synthesise") {
        return refuse("unknown subcommand '" + command + "'; expected: synthesise");
    }
    return run_synthesise({arguments.begin() + 1, arguments.end()});
}

}  // namespace

int main(int count, char** words) {
    try {
        return run({words + 1, words + count});
    } catch (const boost::program_options::error& error) {
        return refuse(error.what());
    } catch (const std::invalid_argument& error) {
        return refuse(error.what());
    } catch (const blockgen::InputError& error) {
        return refuse(error.what());
    } catch (const blockgen::OutputError& error) {
        return refuse(error.what());
    } catch (const std::exception& error) {
        std::cerr << "ground-motion: " << error.what() << '\n';
        return 1;
    }
}
