#pragma once

#include <optional>

#include "dda/results/results.hpp"

namespace rockslope {

/// Shows the progress of a run on stderr: one redrawn line on a terminal, otherwise a plain line every 10 s.
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
    bool on_terminal_;
    bool drawn_ = false;
    double last_shown_ = -1e9;          ///< s, wall time
    std::int64_t first_step_ = -1;      ///< step count before the first call of show()
    std::optional<double> first_done_;  ///< s, time done at the first call in a dynamic stage
    double first_done_wall_ = 0;        ///< s, wall time at that call
};

}  // namespace rockslope
