#include "time_left.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rockslope {

namespace {

std::string duration_text(double seconds) {
    char text[32];
    const long whole = std::lround(seconds);
    if (whole < 3600)
        std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
    return text;
}

}  // namespace

std::string time_left_text(std::optional<double> seconds) {
    constexpr double longest = 100.0 * 3600;
    if (!seconds || std::isnan(*seconds)) return "? left";
    if (*seconds >= longest) return "over 100 h left";
    return duration_text(std::max(*seconds, 0.0)) + " left";
}

void TimeLeft::note(const dda::Progress& now) {
    if (!now.stage.is_static()) {
        if (first_done_) spent_ += now.wall_time - last_wall_;
        if (!first_done_) first_done_ = now.done;
    } else {
        const bool is_first =
            now.state.stage_steps <= 1 || !first_unbalanced_;  // of the stage, or resumed in it
        if (is_first) {
            first_unbalanced_ = smallest_unbalanced_ = now.report.unbalanced_force;
            first_unbalanced_wall_ = now.wall_time;
        }
        smallest_unbalanced_ = std::min(smallest_unbalanced_, now.report.unbalanced_force);
        if (now.trial && !first_trial_wall_) first_trial_wall_ = now.wall_time;
    }
    last_wall_ = now.wall_time;
}

std::optional<double> TimeLeft::after(const dda::Progress& now) {
    note(now);
    if (!now.stage.is_static()) return of_dynamic_stages(now);
    return now.trial ? of_trials(now) : of_static_stage(now);
}

/// By the time computed. Static stages between them are no part of it.
std::optional<double> TimeLeft::of_dynamic_stages(const dda::Progress& now) const {
    const double advanced = now.done - *first_done_;
    if (!(advanced > 0)) return std::nullopt;
    return (now.total - now.done) * spent_ / advanced;
}

/// By the logarithm of the unbalanced force.
std::optional<double> TimeLeft::of_static_stage(const dda::Progress& now) const {
    const double gained = std::log(*first_unbalanced_ / smallest_unbalanced_);
    const double missing = std::log(smallest_unbalanced_ / now.stage.tolerance);
    // The first steps say too little of the way down.
    constexpr double least_gained = 0.1;
    if (!(gained > least_gained) || !std::isfinite(gained) || !std::isfinite(missing)) return std::nullopt;
    return std::max(0.0, missing) * (now.wall_time - first_unbalanced_wall_) / gained;
}

/// By the number of trials.
std::optional<double> TimeLeft::of_trials(const dda::Progress& now) const {
    if (!now.trial->left || now.trial->number < 2) return std::nullopt;
    const double trials_done = now.trial->number - 0.5;  // half of the present one, for want of better
    return (*now.trial->left + 0.5) * (now.wall_time - *first_trial_wall_) / trials_done;
}

}  // namespace rockslope
