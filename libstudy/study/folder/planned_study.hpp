#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/plan/rows.hpp"

namespace rockslope::study {

/// One key that a row sets.
struct Setting {
    Target target;
    std::string value;           ///< TOML; of a file, empty
    std::filesystem::path file;  ///< absolute; empty unless the value is a file
};

/// A cut of the slope, for all rows with the same joints.
struct PlannedCut {
    std::string address;  ///< hash of all that it depends on
    std::vector<Setting> settings;
};

/// The first stages of rows that differ in later ones only.
struct PlannedStart {
    std::string address;
    std::size_t cut = 0;  ///< index
    std::vector<Setting> settings;
    std::size_t rows = 0;  ///< number of rows that begin with it
};

/// A row with what it is computed from.
struct PlannedRow {
    Row row;
    std::string address;
    std::size_t cut = 0;    ///< index
    std::size_t start = 0;  ///< index, where the study branches
    std::vector<Setting> settings;
};

/// All that a study computes, each thing once. Things of equal input have equal addresses, in this plan or a
/// later one.
struct PlannedStudy {
    Plan plan;
    int branch_stages = 0;         ///< number of stages that starts compute; 0: rows run from the beginning
    std::string last_start_stage;  ///< name of the last of them
    std::vector<PlannedCut> cuts;  ///< one without an address of its own, where the plan has a block file
    std::vector<PlannedStart> starts;
    std::vector<PlannedRow> rows;
    std::vector<std::filesystem::path> inputs;  ///< all files that the addresses depend on, absolute

    /// The overrides of all rows: what they write, and those of the plan.
    std::vector<std::string> run_set() const;
};

/// Works out what a plan computes. The models are read with every combination of values that will be computed
/// (of more than 20 000 combinations of the run, with so many), so that a mistake is found now and not in the
/// hundredth row: one slope is cut for that, into a file in `folder` that is
/// removed.
/// @throws InputError for a plan, a model file or a record that cannot be used.
PlannedStudy plan_study(const Plan& plan, const std::filesystem::path& folder);

/// Number of the stage that a key of a run file belongs to; -1: of none.
int stage_of_key(const std::string& key);

}  // namespace rockslope::study
