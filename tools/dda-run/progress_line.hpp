#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dda/results/results.hpp"

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
    /// Estimates of the wall time left, s: by the time computed, by the logarithm of the unbalanced force, by
    /// the number of trials.
    std::optional<double> dynamic_time_left(const dda::Progress& now);
    std::optional<double> static_time_left(const dda::Progress& now);
    std::optional<double> trials_time_left(const dda::Progress& now);

    bool on_terminal_;
    bool drawn_ = false;
    double last_shown_ = -1e9;                ///< s, wall time
    std::int64_t steps_ = 0;                  ///< since this program started the run
    std::optional<double> first_done_;        ///< s, time done at the first call in a dynamic stage
    double first_done_wall_ = 0;              ///< s, wall time at that call
    double first_unbalanced_ = 0;             ///< at the first step of a static stage or trial
    double smallest_unbalanced_ = 0;          ///< since then
    double first_unbalanced_wall_ = 0;        ///< s, wall time of that step
    std::optional<double> first_trial_wall_;  ///< s, wall time of the first step of a strength reduction
};

}  // namespace rockslope
