#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/drawing/canvas.hpp"

namespace rockslope {

/// The columns of a history.csv.
struct HistoryTable {
    std::vector<double> time;                  ///< s
    std::vector<std::string> stage;            ///< name of each row's stage
    std::vector<std::string> names;            ///< headings of the other columns, such as "crest ux (m)"
    std::vector<std::vector<double>> columns;  ///< one for each name

    /// Index of a column by its heading. @throws std::out_of_range naming it.
    std::size_t column(const std::string& name) const;
    /// The names of the points: the headings that end in " ux (m)", without that ending.
    std::vector<std::string> points() const;
};

/// Prefix of the name of a prescribed block in a heading.
inline constexpr const char* prescribed_prefix = "prescribed ";

/// Drops the stages up to the last reset of displacements to zero, unless nothing would remain.
HistoryTable without_reset_stages(const HistoryTable& history);

/// Reads the history of a run; an incomplete last line is ignored. @throws InputError with file and line.
HistoryTable read_history(const std::filesystem::path& path);

/// Draws the displacements of the measured points against time: one panel each for x and y, relative to the
/// base if a block is prescribed, and one panel for the base.
Canvas draw_history(const HistoryTable& history, const PageStyle& style = {});

}  // namespace rockslope
