#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "blockgen/input/distribution.hpp"

namespace rockslope::study {

/// The model file that a factor changes.
enum class ModelFile { slope, run };

/// A key that a factor sets.
struct Target {
    ModelFile file = ModelFile::run;
    std::string key;  ///< path as for --set
};

/// An intensity measure of a record that it can be scaled to.
enum class ScaleMeasure { peak_acceleration, peak_velocity, arias_intensity, spectral_acceleration };

/// Scaling of a record to an intensity.
struct RecordScale {
    ScaleMeasure measure = ScaleMeasure::peak_acceleration;
    double period = 0;   ///< s, of a spectral acceleration, 5 % damped
    std::string record;  ///< name of the factor whose files are scaled
};

/// One thing that differs between the rows of a study.
struct Factor {
    std::string name;
    std::vector<Target> targets;
    std::vector<std::string> values;  ///< TOML values, of a list, a range or files
    std::vector<std::filesystem::path>
        files;                        ///< absolute, one for each value; empty unless values are files
    std::vector<double> intensities;  ///< SI, one for each value, of a scaled record
    std::optional<blockgen::Distribution> distribution;  ///< in place of values
    std::string unit;  ///< of the numbers of a distribution or a range: "deg"
    std::optional<RecordScale> scale;
    std::string paired_with;  ///< the factor with whose value its own goes; empty: none
};

/// How rows are chosen.
enum class DesignKind { full, latin_hypercube, sobol, monte_carlo, incremental, morris, one_at_a_time };

/// The design of a study.
struct Design {
    DesignKind kind = DesignKind::full;
    int samples = 0;       ///< rows of the sampled designs, trajectories of Morris's
    int levels = 4;        ///< of Morris's design
    bool indices = false;  ///< Sobol's design: rows for the indices, (factors + 2) * samples
    std::uint64_t seed = 1;
    std::string intensity;  ///< incremental: the factor whose values are tried in increasing order
    std::string measure;    ///< incremental: the measure by which a row has failed
    double limit = 0;       ///< incremental: of that measure
};

/// What a measure takes from a row.
enum class MeasureKind {
    displacement,       ///< m, of a point, of a region's mean or farthest block, or of the farthest block
    moved_volume,       ///< m3 per metre, of the blocks beyond a limit
    front,              ///< m, x of the farthest corner of these blocks
    run_out,            ///< m, from the highest corner of these blocks at the start to their front
    travel_angle,       ///< rad, of the line between these two
    surface,            ///< m, y of the surface at a station
    deposit_height,     ///< m, of the surface over that at the start, at a station or the largest
    deposit_thickness,  ///< m, vertical, of the blocks beyond a limit, at a station or the largest
    first_slip,         ///< s of shaking
    factor_of_safety    ///< of a strength reduction
};

/// One measured column of the results.
struct Measure {
    std::string name;
    MeasureKind kind = MeasureKind::displacement;
    std::string point;        ///< of a displacement
    std::string region;       ///< of a displacement
    bool is_peak = false;     ///< the largest of the run in place of that at its end
    bool is_largest = false;  ///< of a region: the farthest block in place of the mean
    double limit = 0;         ///< m, of moved blocks
    std::optional<double> x;  ///< m, station of a surface or a deposit; nothing: the largest of all
    double width = 0;         ///< m, over which the largest height is a mean
};

/// The profile of each row that `dda-study collect` writes.
struct ProfilePlan {
    double interval = 0;  ///< m, between stations
    double limit = 0;     ///< m, of moved blocks
};

/// A fragility curve that the report of a study shows.
struct FragilityPlan {
    std::string measure;
    std::string intensity;
    double limit = 0;
    bool by_demands = false;  ///< regression of the demands in place of the outcomes
};

/// What rows write, besides summaries.
struct RowOutput {
    int frames = 0;
    bool joint_frames = false;
    bool step_log = false;
    double history_interval = 0.1;  ///< s
};

/// A study as the user described it.
struct Plan {
    std::filesystem::path file;                   ///< absolute
    std::filesystem::path slope;                  ///< absolute; empty: rows share one block file
    std::filesystem::path blocks;                 ///< absolute; empty: cut from `slope`
    std::filesystem::path run;                    ///< absolute
    std::vector<std::string> slope_set, run_set;  ///< overrides of all rows
    std::vector<Factor> factors;
    Design design;
    int replicates = 1;  ///< runs of each row; all but the first begin with a perturbation
    std::vector<Measure> measures;
    std::vector<FragilityPlan> fragilities;
    std::optional<ProfilePlan> profile;
    RowOutput output;
    double row_time = 0;  ///< s, wall time of a row that the user expects; 0: not given

    /// Index of a factor. @throws std::out_of_range for an unknown name.
    std::size_t index_of(const std::string& factor) const;
};

/// Reads a plan. @throws InputError, one line with the place and what was expected.
Plan read_plan(const std::filesystem::path& file);

/// A commented plan to start from.
std::string plan_template();

}  // namespace rockslope::study
