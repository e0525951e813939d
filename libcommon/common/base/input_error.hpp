#pragma once

#include <stdexcept>
#include <string>

namespace rockslope {

/// Where in the user's input something stands. Line and column count from 1; 0 means "not known".
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;

    /// "file:line:column", with the unknown parts left out.
    std::string text() const;
};

/// Bad input: what() is one line, "file:line:column: WHAT; expected EXPECTED". Without an expectation the
/// line ends after WHAT; line breaks inside either part become spaces. The programs print it to stderr and
/// exit with code 2, before any result is touched.
class InputError : public std::runtime_error {
  public:
    InputError(const SourceLocation& place, const std::string& what, const std::string& expected);

    const SourceLocation& place() const { return place_; }

  private:
    SourceLocation place_;
};

}  // namespace rockslope
