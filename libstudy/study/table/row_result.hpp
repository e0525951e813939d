#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/folder/input_check.hpp"
#include "study/plan/plan.hpp"

namespace rockslope::study {

/// Where a row is.
enum class RowState {
    completed,   ///< done
    collapsed,   ///< done: a displacement passed the limit of its stage
    not_needed,  ///< done: incremental, and a row of a smaller intensity has failed
    failed,      ///< ended without a result, for a reason; make tries it again
    stopped,     ///< interrupted; make goes on from its checkpoint, or anew
    running,     ///< a process of this machine, or of another one, computes it
    waiting      ///< not begun
};

/// The name of a state in tables: "completed", "not needed", ...
std::string state_name(RowState state);
/// Whether a row of this state needs no more computing.
bool is_done(RowState state);

/// The folders of a row, and of what it is computed from.
struct RowFolders {
    std::filesystem::path results;
    std::filesystem::path start;   ///< empty where rows do not branch
    std::filesystem::path blocks;  ///< the cut; empty where all rows share one block file
};

/// What is known of a row.
struct RowResult {
    RowState state = RowState::waiting;
    std::string cause;    ///< of a failure, in a few words, the same for like failures: "not settled"
    std::string message;  ///< one line: why the row failed or collapsed
    std::vector<std::optional<double>> measures;     ///< in the order of the plan; of rows that are done
    std::vector<std::optional<double>> intensities;  ///< in the order of intensity_headings()
    std::optional<double> collapse_time;             ///< s
    std::optional<double> collapse_limit;            ///< m
    double wall_time = 0;                            ///< s
    std::string commit;                              ///< of the program that computed it
    RowInputs inputs;                                ///< what it was computed from
};

/// Reads what is known of a row. A row whose start or cut failed has failed, for their reason.
/// @throws InputError for a summary that is none.
RowResult read_row(const RowFolders& folders, const std::vector<Measure>& measures);

/// Intensities, in the order of intensity_headings(), of the same motion times `ratio`.
void scale_intensities(double ratio, std::vector<std::optional<double>>& intensities);

/// Headings of the intensity measures of a row's record: "PGA (m/s2)", ..., "Sa(0.5) (m/s2)".
std::vector<std::string> intensity_headings();

/// Heading of a measure, its name and unit: "crest (m)".
std::string measure_heading(const Measure& measure);

}  // namespace rockslope::study
