#include "study/table/row_result.hpp"

#include <signal.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/base/degree.hpp"
#include "common/base/input_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "study/table/deposit.hpp"
#include "study/table/moved_blocks.hpp"

namespace rockslope::study {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

Json read_json(const fs::path& file) {
    Json json = Json::parse(read_text_file(file), nullptr, false);
    if (json.is_discarded() || !json.is_object() || !json.contains("status"))
        throw InputError({file.string()}, "is not a summary of dda-run", "summary.json as the run wrote it");
    return json;
}

std::optional<double> number_in(const Json& json, const char* key) {
    if (!json.is_object() || !json.contains(key) || !json.at(key).is_number()) return std::nullopt;
    return json.at(key).get<double>();
}

std::string text_in(const Json& json, const char* key) {
    return json.contains(key) && json.at(key).is_string() ? json.at(key).get<std::string>() : "";
}

/// The entry with this name in a list of the summary; null if there is none.
const Json& named(const Json& summary, const char* list, const std::string& name) {
    static const Json none;
    if (!summary.contains(list)) return none;
    for (const Json& entry : summary.at(list))
        if (text_in(entry, "name") == name) return entry;
    return none;
}

std::optional<double> length_of(const Json& entry, const char* key) {
    if (!entry.is_object() || !entry.contains(key) || entry.at(key).size() != 2) return std::nullopt;
    return std::hypot(entry.at(key).at(0).get<double>(), entry.at(key).at(1).get<double>());
}

std::optional<double> displacement_in(const Json& summary, const Measure& measure) {
    if (!measure.point.empty()) {
        const Json& point = named(summary, "points", measure.point);
        return measure.is_peak ? number_in(point, "peak_relative_displacement")
                               : length_of(point, "permanent_displacement");
    }
    if (measure.region.empty())
        return number_in(summary.value("farthest_block", Json()),
                         measure.is_peak ? "peak_displacement" : "displacement");
    const std::string key = std::string(measure.is_peak ? "peak_" : "") +
                            (measure.is_largest ? "largest" : "mean") + "_displacement";
    return number_in(named(summary, "regions", measure.region), key.c_str());
}

/// Between the largest factor that stands and the smallest that fails; one of them where the other is
/// unknown.
std::optional<double> factor_of_safety(const Json& summary) {
    const Json search = summary.value("factor_of_safety", Json());
    const auto stands = number_in(search, "stands"), fails = number_in(search, "fails");
    if (stands && fails) return std::sqrt(*stands * *fails);
    return stands ? stands : fails;
}

/// A row that is done. Its files are read where a measure needs them.
class DoneRow {
  public:
    DoneRow(const Json& summary, fs::path folder) : summary_(summary), folder_(std::move(folder)) {}

    std::optional<double> value_of(const Measure& measure) {
        switch (measure.kind) {
            case MeasureKind::displacement:
                return displacement_in(summary_, measure);
            case MeasureKind::first_slip:
                return number_in(summary_.value("first_slip", Json()), "first_time_of_shaking");
            case MeasureKind::factor_of_safety:
                return factor_of_safety(summary_);
            case MeasureKind::surface:
                return deposit().surface(*measure.x);
            case MeasureKind::deposit_height:
                return measure.x ? deposit().height(*measure.x) : deposit().largest_height(measure.width);
            case MeasureKind::deposit_thickness:
                return measure.x ? deposit().thickness(*measure.x, measure.limit)
                                 : deposit().largest_thickness(measure.limit);
            default:
                return of_moved_blocks(measure);
        }
    }

  private:
    std::optional<double> of_moved_blocks(const Measure& measure) const {
        const MovedBlocks moved = moved_blocks(folder_ / "blocks.csv", measure.limit);
        if (measure.kind == MeasureKind::moved_volume) return moved.volume;
        if (measure.kind == MeasureKind::front) return moved.front;
        if (measure.kind == MeasureKind::run_out) return moved.run_out;
        if (!moved.travel_angle) return std::nullopt;
        return *moved.travel_angle / degree;
    }
    const Deposit& deposit() {
        if (!deposit_) deposit_.emplace(read_outlines(folder_));
        return *deposit_;
    }

    const Json& summary_;
    fs::path folder_;
    std::optional<Deposit> deposit_;
};

const char* const intensity_keys[] = {"peak_acceleration",    "peak_velocity",
                                      "peak_displacement",    "arias_intensity",
                                      "significant_duration", "cumulative_absolute_velocity",
                                      "mean_period"};
const char* const intensity_names[] = {"PGA (m/s2)", "PGV (m/s)", "PGD (m)", "Arias (m/s)",
                                       "D5-95 (s)",  "CAV (m/s)", "Tm (s)"};
/// The power of the motion that each of them grows with; spectral accelerations grow with the first.
constexpr int intensity_powers[] = {1, 1, 1, 2, 0, 1, 0};
const char* const spectral_names[] = {"0.1", "0.2", "0.3", "0.5", "1", "2", "3"};  // s, as in summaries

/// The measures of the motion with the largest acceleration.
std::vector<std::optional<double>> intensities_in(const Json& summary) {
    std::vector<std::optional<double>> values(std::size(intensity_keys) + std::size(spectral_names));
    const Json* largest = nullptr;
    double peak = 0;
    if (summary.contains("motions"))
        for (const Json& motion : summary.at("motions"))
            if (const auto acceleration = number_in(motion, "peak_acceleration");
                acceleration && *acceleration > peak) {
                peak = *acceleration;
                largest = &motion;
            }
    if (largest == nullptr) return values;
    for (std::size_t k = 0; k < std::size(intensity_keys); ++k)
        values[k] = number_in(*largest, intensity_keys[k]);
    for (const Json& ordinate : largest->value("spectral_acceleration", Json::array()))
        for (std::size_t k = 0; k < std::size(spectral_names); ++k)
            if (shortest_text(number_in(ordinate, "period").value_or(0)) == spectral_names[k])
                values[std::size(intensity_keys) + k] = number_in(ordinate, "acceleration");
    return values;
}

std::string last_line(const fs::path& file) {
    std::ifstream text(file);
    std::string line, last;
    while (std::getline(text, line))
        if (!line.empty()) last = line;
    return last;
}

/// Whether a process of this machine is there, and has not ended without being waited for.
bool is_process(int process) {
    if (::kill(process, 0) != 0) return false;
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    std::getline(file, text);
    const std::size_t name_end = text.rfind(')');  // the name may have spaces and parentheses
    return name_end == std::string::npos || text.substr(name_end, 3) != ") Z";
}

/// Whether the process that a note names goes on: one of another machine is taken to.
bool is_alive(const fs::path& note) {
    std::ifstream text(note), kernel("/proc/sys/kernel/hostname");
    std::string host, here;
    int process = 0;
    if (!(text >> host >> process)) return false;
    kernel >> here;
    return host != here || is_process(process);
}

RowInputs inputs_in(const Json& summary) {
    RowInputs inputs;
    for (const Json& file : summary.value("inputs", Json::array()))
        inputs.files.push_back({text_in(file, "file"), text_in(file, "sha256")});
    for (const Json& text : summary.value("overrides", Json::array()))
        if (text.is_string()) inputs.overrides.push_back(text.get<std::string>());
    inputs.fingerprint = text_in(summary, "fingerprint");
    return inputs;
}

void read_done(const fs::path& folder, const std::vector<Measure>& measures, RowResult& result) {
    const Json summary = read_json(folder / "summary.json");
    const std::string status = text_in(summary, "status");
    result.state = status == "collapsed" ? RowState::collapsed : RowState::completed;
    result.message = text_in(summary, "message");
    result.wall_time = number_in(summary, "wall_time").value_or(0);
    result.commit = text_in(summary, "commit");
    result.inputs = inputs_in(summary);
    if (summary.contains("collapse")) {
        result.collapse_time = number_in(summary.at("collapse"), "time");
        result.collapse_limit = number_in(summary.at("collapse"), "limit");
    }
    result.intensities = intensities_in(summary);
    // A row whose start has collapsed has its summary alone.
    if (!fs::exists(folder / "blocks.csv")) return;
    DoneRow row(summary, folder);
    for (std::size_t k = 0; k < measures.size(); ++k) result.measures[k] = row.value_of(measures[k]);
}

/// The state of a folder without a summary. @param what to say before the reason: "", "start: ".
bool read_unfinished(const fs::path& folder, const std::string& what, RowResult& result) {
    if (fs::exists(folder / "running") && is_alive(folder / "running")) {
        result.state = RowState::running;
        return true;
    }
    if (fs::exists(folder / "failed.json")) {
        const Json summary = read_json(folder / "failed.json");
        const std::string status = text_in(summary, "status");
        result.state = status == "stopped" ? RowState::stopped : RowState::failed;
        result.cause = result.state == RowState::failed ? what + status : "";
        result.message = text_in(summary, "message");
        return true;
    }
    // The note of a run that ended is empty.
    const bool was_interrupted = fs::exists(folder / "running") && fs::file_size(folder / "running") > 0;
    if (was_interrupted || fs::exists(folder / "checkpoint.h5")) {
        result.state = RowState::stopped;
        return true;
    }
    if (!fs::exists(folder / "log")) return false;
    result.state = RowState::failed;
    // A run takes room for its log before it begins.
    const bool is_empty = fs::file_size(folder / "log") == 0;
    result.message = is_empty ? "log: cannot be written: no space left" : last_line(folder / "log");
    const bool is_unwritten = result.message.find(": cannot be written") != std::string::npos;
    result.cause = what + (is_unwritten ? "not written" : "bad input, or not run");
    return true;
}

}  // namespace

std::string state_name(RowState state) {
    const char* const names[] = {"completed", "collapsed", "not needed", "failed",
                                 "stopped",   "running",   "waiting"};
    return names[static_cast<int>(state)];
}

bool is_done(RowState state) {
    return state == RowState::completed || state == RowState::collapsed || state == RowState::not_needed;
}

RowResult read_row(const RowFolders& folders, const std::vector<Measure>& measures) {
    RowResult result;
    result.measures.resize(measures.size());
    result.intensities.resize(intensity_headings().size());
    if (fs::exists(folders.results / "summary.json")) {
        read_done(folders.results, measures, result);
        return result;
    }
    if (read_unfinished(folders.results, "", result)) return result;
    if (!folders.start.empty() && !fs::exists(folders.start / "summary.json") &&
        read_unfinished(folders.start, "start ", result) && result.state == RowState::failed)
        return result;
    result.state = RowState::waiting;
    if (folders.blocks.empty() || fs::exists(folders.blocks)) return result;
    const fs::path log = fs::path(folders.blocks).replace_extension(".log");
    if (!fs::exists(log)) return result;
    result.state = RowState::failed;
    result.cause = "cut";
    result.message = last_line(log);
    return result;
}

void scale_intensities(double ratio, std::vector<std::optional<double>>& intensities) {
    for (std::size_t k = 0; k < intensities.size(); ++k) {
        if (!intensities[k] || (k < std::size(intensity_powers) && intensity_powers[k] == 0)) continue;
        const bool is_square = k < std::size(intensity_powers) && intensity_powers[k] == 2;
        *intensities[k] *= is_square ? ratio * ratio : ratio;
    }
}

std::vector<std::string> intensity_headings() {
    std::vector<std::string> headings(std::begin(intensity_names), std::end(intensity_names));
    for (const char* period : spectral_names) headings.push_back(std::string("Sa(") + period + ") (m/s2)");
    return headings;
}

std::string measure_heading(const Measure& measure) {
    switch (measure.kind) {
        case MeasureKind::moved_volume:
            return measure.name + " (m3/m)";
        case MeasureKind::travel_angle:
            return measure.name + " (deg)";
        case MeasureKind::first_slip:
            return measure.name + " (s)";
        case MeasureKind::factor_of_safety:
            return measure.name;
        default:
            return measure.name + " (m)";
    }
}

}  // namespace rockslope::study
