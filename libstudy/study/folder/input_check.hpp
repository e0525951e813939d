#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/base/read_log.hpp"

namespace rockslope::study {

/// What a row was computed from, as its summary says.
struct RowInputs {
    std::vector<InputFile> files;  ///< as they were read; paths relative to the folder of the study
    std::vector<std::string> overrides;
    std::string fingerprint;  ///< digest of all that its results depend on
};

/// Compares what rows were computed from with the files as they are now.
class InputCheck {
  public:
    /// @param folder of the study; @param run_file of its plan.
    InputCheck(const std::filesystem::path& folder, const std::filesystem::path& run_file)
        : folder_(folder), run_file_(run_file) {}

    /// The files, with commas between them, that a row was computed from with other contents than they have
    /// now. Changes that do not matter, such as a comment of the run file, are none. @param blocks block file
    /// of the row. @return nothing where all is the same, and for a row that does not say what it was
    /// computed from.
    std::optional<std::string> different_files(const RowInputs& row, const std::filesystem::path& blocks);

  private:
    const std::string& digest_of(const std::filesystem::path& file);
    bool gives_the_same(const RowInputs& row, const std::filesystem::path& blocks) const;

    std::filesystem::path folder_, run_file_;
    std::map<std::filesystem::path, std::string> digests_;  ///< of the files now; empty: cannot be read
};

}  // namespace rockslope::study
