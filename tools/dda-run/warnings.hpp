#pragma once

#include <string>
#include <vector>

namespace rockslope {

/// What the program says of a run: printed to stderr at once, and kept for the summary.
class Warnings {
  public:
    /// Prints one line, after the program's name, and keeps it. @param format of printf, without a line end.
    [[gnu::format(printf, 2, 3)]] void tell(const char* format, ...);
    /// The lines so far.
    const std::vector<std::string>& lines() const { return lines_; }

  private:
    std::vector<std::string> lines_;
};

}  // namespace rockslope
