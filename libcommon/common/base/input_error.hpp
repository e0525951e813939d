#pragma once

#include <stdexcept>
#include <string>

namespace rockslope {

/// A position in the user's input. Line and column count from 1; 0 means unknown.
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;

    /// "file:line:column" without the unknown parts.
    std::string text() const;
};

/// Bad input. what() is one line, "file:line:column: WHAT; expected EXPECTED"; with an empty expectation it
/// ends after WHAT. Line breaks inside either part become spaces. The programs print it to stderr and exit
/// with code 2 before they touch any result.
class InputError : public std::runtime_error {
  public:
    InputError(const SourceLocation& place, const std::string& what, const std::string& expected);

    /// Where the fault is.
    const SourceLocation& place() const { return place_; }

  private:
    SourceLocation place_;
};

}  // namespace rockslope
