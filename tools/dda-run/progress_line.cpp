#include "progress_line.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace rockslope {

namespace {

constexpr double redraw_interval = 0.1;  // s of wall time

std::size_t terminal_width() {
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string formatted(const char* format, auto... values) {
    char text[128];
    std::snprintf(text, sizeof text, format, values...);
    return text;
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

std::vector<std::string> ProgressLine::fields_of(const dda::Progress& now) {
    const dda::StepReport& report = now.report;
    const std::string left = time_left_text(time_left_.after(now));
    std::vector<std::string> fields = {now.stage.name};
    if (!now.stage.is_static()) {
        fields.push_back(formatted("t %.3f of %.6g s", now.state.stage_time, now.stage.duration));
        fields.push_back(left);
    } else {
        if (now.trial)
            fields.push_back(formatted("trial %d, factor %.4g", now.trial->number, now.trial->factor));
        fields.push_back(left);
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
