#pragma once

#include "common/config/config_table.hpp"
#include "study/plan/plan.hpp"

namespace rockslope::study {

/// Reads one [[factor]]. The factors before it are known: it may be paired with one of them or scale the
/// records of one. @throws InputError.
Factor read_factor(const ConfigTable& table, const std::vector<Factor>& before,
                   const std::filesystem::path& folder);

/// The measure of a text such as "PGA", "PGV", "Arias" or "Sa(0.5)". Nothing for any other.
std::optional<RecordScale> scale_of_name(const std::string& name);

}  // namespace rockslope::study
