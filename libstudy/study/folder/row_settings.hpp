#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "study/folder/planned_study.hpp"

namespace rockslope::study {

/// The intensities of the records of a plan, read and measured once.
class RecordFactors {
  public:
    /// @param plan which must outlive this.
    explicit RecordFactors(const Plan& plan) : plan_(plan) {}
    /// The factor by which the record of a row is scaled to the intensity that factor `scaled` gives it.
    /// @throws InputError for a record that cannot be read or has no motion.
    double scale_of(const Row& row, std::size_t scaled);

  private:
    const Plan& plan_;
    std::map<std::pair<std::size_t, std::filesystem::path>, double> known_;  ///< intensity by factor and file
};

/// What a row sets, in the order of the factors.
std::vector<Setting> row_settings(const Plan& plan, const Row& row, RecordFactors& records);

/// A setting as --set takes it, "key=value". @param folder that paths of files are written relative to;
/// empty: absolute.
std::string override_text(const Setting& setting, const std::filesystem::path& folder);

}  // namespace rockslope::study
