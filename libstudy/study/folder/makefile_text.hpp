#pragma once

#include <filesystem>
#include <string>

#include "study/folder/planned_study.hpp"

namespace rockslope::study {

/// Where the programs are, absolute.
struct Programs {
    std::filesystem::path folder;
};

/// The Makefile of a study: a rule for each cut, each start and each row, and a target
/// runs/NUMBER/summary.json for each row. Make writes it again when an input has changed. @param folder of
/// the study, absolute.
std::string makefile_text(const PlannedStudy& study, const std::filesystem::path& folder,
                          const Programs& programs);

/// The name of a row's folder within runs/: "000123". Rows count from 1.
std::string row_name(std::size_t index);

}  // namespace rockslope::study
