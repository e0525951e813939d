#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace rockslope {

/// The tables of a run that a report shows, each where its file exists: histories of the measured points
/// relative to the base, acceleration and response spectrum of the base, the blocks that moved most, the
/// largest penetration of the steps, the summary, and the text of the model. SI units.
/// @throws InputError for a file that is damaged.
nlohmann::json report_tables(const std::filesystem::path& folder);

}  // namespace rockslope
