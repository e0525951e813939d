#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rockslope {

/// The command line of a subcommand, and its help.
class CommandOptions {
  public:
    /// @param synopsis "status STUDY [options]", without the program's name; @param purpose a sentence.
    CommandOptions(std::string synopsis, std::string purpose);

    /// To add options to: options().add_options()(...).
    boost::program_options::options_description& options() { return options_; }
    /// Parses the arguments. @return false after printing the help, which the option --help asks for.
    /// @throws InputError for other options.
    bool parse(const std::vector<std::string>& arguments);

    /// The one argument that is no option. @param what for the message: "the folder of a study".
    /// @throws InputError when there is none, or more than one.
    std::string argument(const std::string& what) const;
    /// All arguments that are no options.
    std::vector<std::string> arguments() const;
    /// Whether the option is given.
    bool has(const char* name) const { return values_.count(name) > 0; }
    /// The value of an option, which must be given or have a default.
    template <class Value>
    const Value& get(const char* name) const {
        return values_[name].as<Value>();
    }
    /// The value of an option for a path; nothing if it is not given. @throws InputError for an empty one.
    std::optional<std::filesystem::path> path(const char* name) const;
    /// The value of an option that must be given. @throws InputError without it.
    std::string required(const char* name, const std::string& expected) const;
    /// "dda-study status", for messages.
    std::string program() const;

  private:
    std::string synopsis_, purpose_;
    boost::program_options::options_description options_;
    boost::program_options::variables_map values_;
};

}  // namespace rockslope
