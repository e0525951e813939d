#pragma once

#include <string>
#include <vector>

#include "dda/results/results.hpp"
#include "time_left.hpp"

namespace rockslope {

/// Shows the progress of a run on stderr, where that is a terminal: one redrawn line, as long as the terminal
/// is wide, with an estimate of the time left.
class ProgressLine {
  public:
    ProgressLine();
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const dda::Progress& progress);
    /// Removes the progress line from the terminal.
    void clear();

  private:
    /// The parts of the line, the more important ones first.
    std::vector<std::string> fields_of(const dda::Progress& now);

    bool on_terminal_;
    bool drawn_ = false;
    double last_shown_ = -1e9;  ///< s, wall time
    std::int64_t steps_ = 0;    ///< since this program started the run
    TimeLeft time_left_;
};

}  // namespace rockslope
