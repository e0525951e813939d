#include "progress_line.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rockslope {

namespace {

constexpr double redraw_interval = 0.1;  // s of wall time

std::size_t terminal_width() {
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string duration_text(double seconds) {
    char text[32];
    const long whole = std::lround(seconds);
    if (whole < 3600)
        std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
    return text;
}

std::string formatted(const char* format, auto... values) {
    char text[128];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string time_left(std::optional<double> seconds) {
    constexpr double longest = 100.0 * 3600;
    if (!seconds || std::isnan(*seconds)) return "? left";
    if (*seconds >= longest) return "over 100 h left";
    return duration_text(std::max(*seconds, 0.0)) + " left";
}

/// As many of the fields, in their order, as a line has room for.
std::string joined(const std::vector<std::string>& fields, std::size_t width) {
    std::string line;
    for (const std::string& field : fields) {
        const std::string more = line.empty() ? field : "  " + field;
        if (line.size() + more.size() > width) continue;
        line += more;
    }
    return line;
}

}  // namespace

ProgressLine::ProgressLine() : on_terminal_(::isatty(STDERR_FILENO) == 1) {}

std::optional<double> ProgressLine::dynamic_time_left(const dda::Progress& now) {
    if (!first_done_) {
        first_done_ = now.done;
        first_done_wall_ = now.wall_time;
    }
    const double advanced = now.done - *first_done_;
    if (!(advanced > 0)) return std::nullopt;
    return (now.total - now.done) * (now.wall_time - first_done_wall_) / advanced;
}

std::optional<double> ProgressLine::static_time_left(const dda::Progress& now) {
    if (now.state.stage_steps <= 1) {
        first_unbalanced_ = smallest_unbalanced_ = now.report.unbalanced_force;
        first_unbalanced_wall_ = now.wall_time;
    }
    smallest_unbalanced_ = std::min(smallest_unbalanced_, now.report.unbalanced_force);
    const double gained = std::log(first_unbalanced_ / smallest_unbalanced_);
    const double missing = std::log(smallest_unbalanced_ / now.stage.tolerance);
    // The first steps say too little of the way down.
    constexpr double least_gained = 0.1;
    if (!(gained > least_gained) || !std::isfinite(missing)) return std::nullopt;
    return std::max(0.0, missing) * (now.wall_time - first_unbalanced_wall_) / gained;
}

std::optional<double> ProgressLine::trials_time_left(const dda::Progress& now) {
    if (!first_trial_wall_) first_trial_wall_ = now.wall_time;
    if (!now.trial->left || now.trial->number < 2) return std::nullopt;
    const double trials_done = now.trial->number - 0.5;  // half of the present one, for want of better
    return (*now.trial->left + 0.5) * (now.wall_time - *first_trial_wall_) / trials_done;
}

std::vector<std::string> ProgressLine::fields_of(const dda::Progress& now) {
    const dda::StepReport& report = now.report;
    std::vector<std::string> fields = {now.stage.name};
    if (now.stage.kind == dda::StageKind::dynamic) {
        const std::optional<double> left = dynamic_time_left(now);
        fields.push_back(formatted("t %.3f of %.6g s", now.state.stage_time, now.stage.duration));
        fields.push_back(time_left(left));
    } else {
        const std::optional<double> of_stage = static_time_left(now);
        if (now.trial)
            fields.push_back(formatted("trial %d, factor %.4g", now.trial->number, now.trial->factor));
        fields.push_back(time_left(now.trial ? trials_time_left(now) : of_stage));
        fields.push_back(
            formatted("unbalanced %.1e, goal %.0e", report.unbalanced_force, now.stage.tolerance));
        fields.push_back(formatted("step %lld", static_cast<long long>(now.state.stage_steps)));
    }
    const double rate = static_cast<double>(steps_) / std::max(now.wall_time, 1e-9);
    fields.push_back(formatted("dt %.3g ms", 1e3 * report.step));
    fields.push_back(formatted("%d iterations", report.iterations));
    fields.push_back(formatted(rate < 10 ? "%.1f steps/s" : "%.0f steps/s", rate));
    return fields;
}

void ProgressLine::show(const dda::Progress& progress) {
    if (!on_terminal_) return;
    ++steps_;
    const std::vector<std::string> fields = fields_of(progress);
    if (progress.wall_time - last_shown_ < redraw_interval) return;
    last_shown_ = progress.wall_time;
    std::fprintf(stderr, "\r\x1b[K%s", joined(fields, terminal_width() - 1).c_str());
    std::fflush(stderr);
    drawn_ = true;
}

void ProgressLine::clear() {
    if (drawn_) std::fputs("\r\x1b[K", stderr);
    drawn_ = false;
}

}  // namespace rockslope
