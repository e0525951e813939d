#pragma once

#include <optional>
#include <string>

#include "dda/results/results.hpp"

namespace rockslope {

/// Shows on stderr how far a run is: on a terminal one line that is redrawn, elsewhere a plain line now and
/// then.
class ProgressLine {
  public:
    ProgressLine();
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const dda::Progress& progress);
    /// Takes the live line off the terminal.
    void clear();

  private:
    bool on_terminal_;
    bool drawn_ = false;
    double last_shown_ = -1e9;          ///< s of wall time
    std::int64_t first_step_ = -1;      ///< step count when first asked
    std::optional<double> first_done_;  ///< s of the dynamic stages when first asked in one
    double first_done_wall_ = 0;        ///< s of wall time then
};

}  // namespace rockslope
