#include "progress_line.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rockslope {

namespace {

constexpr double terminal_interval = 0.1;  // s of wall time between redraws
constexpr double plain_interval = 10;      // s of wall time between lines

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

}  // namespace

ProgressLine::ProgressLine() : on_terminal_(::isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const dda::Progress& progress) {
    if (first_step_ < 0) first_step_ = progress.state.step_count - 1;
    const bool dynamic = progress.stage.kind == dda::StageKind::dynamic;
    if (dynamic && !first_done_) {
        first_done_ = progress.done;
        first_done_wall_ = progress.wall_time;
    }
    if (progress.wall_time - last_shown_ < (on_terminal_ ? terminal_interval : plain_interval)) return;
    if (!on_terminal_ && last_shown_ < 0 && progress.wall_time < 1) return;  // short runs stay silent
    last_shown_ = progress.wall_time;

    const double rate =
        static_cast<double>(progress.state.step_count - first_step_) / std::max(progress.wall_time, 1e-9);
    char text[256];
    if (dynamic) {
        const double advanced = progress.done - *first_done_;
        const double left = advanced > 0 ? (progress.total - progress.done) *
                                               (progress.wall_time - first_done_wall_) / advanced
                                         : 0;
        std::snprintf(text, sizeof text,
                      "%s  t %.3f of %.6g s  dt %.3g ms  %d iterations  %.0f steps/s  %s left",
                      progress.stage.name.c_str(), progress.state.stage_time, progress.stage.duration,
                      1e3 * progress.report.step, progress.report.iterations, rate,
                      advanced > 0 ? duration_text(left).c_str() : "?");
    } else {
        std::snprintf(text, sizeof text,
                      "%s  step %lld  unbalanced %.2e of %.0e  dt %.3g ms  %d iterations  %.0f steps/s",
                      progress.stage.name.c_str(), static_cast<long long>(progress.state.step_count),
                      progress.report.unbalanced_force, progress.stage.tolerance, 1e3 * progress.report.step,
                      progress.report.iterations, rate);
    }
    std::string line = text;
    if (on_terminal_) {
        line.resize(std::min(line.size(), terminal_width() - 1));
        std::fprintf(stderr, "\r\x1b[K%s", line.c_str());
        drawn_ = true;
    } else {
        std::fprintf(stderr, "%s\n", line.c_str());
    }
    std::fflush(stderr);
}

void ProgressLine::clear() {
    if (drawn_) std::fputs("\r\x1b[K", stderr);
    drawn_ = false;
}

}  // namespace rockslope
