#pragma once

#include <optional>
#include <string>

#include "dda/results/results.hpp"

namespace rockslope {

/// Estimates the wall time that a run, or its static stage, has left.
class TimeLeft {
  public:
    /// The estimate after a step, s; nothing where the steps so far do not tell. Every step must be given.
    std::optional<double> after(const dda::Progress& now);

  private:
    std::optional<double> of_dynamic_stages(const dda::Progress& now) const;
    std::optional<double> of_static_stage(const dda::Progress& now) const;
    std::optional<double> of_trials(const dda::Progress& now) const;
    void note(const dda::Progress& now);

    double last_wall_ = 0;                    ///< s, wall time of the last step
    std::optional<double> first_done_;        ///< s, time done at the first step in a dynamic stage
    double spent_ = 0;                        ///< s of wall time, for the later steps of dynamic stages
    std::optional<double> first_unbalanced_;  ///< at the first step of a static stage or trial
    double smallest_unbalanced_ = 0;          ///< since then
    double first_unbalanced_wall_ = 0;        ///< s, wall time of that step
    std::optional<double> first_trial_wall_;  ///< s, wall time of the first step of a strength reduction
};

/// "1:05 left"; "? left" for nothing, and for what is no time.
std::string time_left_text(std::optional<double> seconds);

}  // namespace rockslope
