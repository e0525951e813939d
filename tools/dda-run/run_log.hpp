#pragma once

#include <filesystem>
#include <string>

namespace rockslope {

/// What a run of a study's Makefile prints, in the file `log` of its folder, and meanwhile the machine and
/// the process that compute it, in the file `running`. It stands in for a shell with redirections: make
/// starts dda-run itself, which takes a millisecond less for each row.
class RunLog {
  public:
    /// Makes the folder, prints the title, and sends the standard output and the standard error to the log.
    /// @throws InputError, OutputError when the folder cannot be made or written to.
    RunLog(const std::filesystem::path& folder, std::string title);

    /// Empties `running`, and of a run that did not end well prints the last line of the log after the title,
    /// on what was the standard error. @param code of the program.
    void finish(int code) const;

  private:
    std::filesystem::path folder_;
    std::string title_;
    int errors_;  ///< what was the standard error
};

}  // namespace rockslope
