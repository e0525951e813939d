#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rockslope {

/// The numbers of a history.csv, column by column.
struct HistoryTable {
    std::vector<double> time;                  ///< s
    std::vector<std::string> stage;            ///< name of each row's stage
    std::vector<std::string> names;            ///< heading of each further column of numbers, "crest ux (m)"
    std::vector<std::vector<double>> columns;  ///< one for each name

    /// Index of a column by its heading; throws std::out_of_range naming it.
    std::size_t column(const std::string& name) const;
    /// The points: what stands before " ux (m)" in the headings.
    std::vector<std::string> points() const;
};

/// What stands before the name of a prescribed block in a heading.
inline constexpr const char* prescribed_prefix = "prescribed ";

/// Drops the stages at whose end displacements were set to zero, unless nothing would be left: what they show
/// was not kept.
HistoryTable without_reset_stages(const HistoryTable& history);

/// Reads the history of a run; a last line that is not finished yet is left out. @throws InputError
/// with file:line.
HistoryTable read_history(const std::filesystem::path& path);

}  // namespace rockslope
