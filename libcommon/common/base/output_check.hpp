#pragma once

#include <filesystem>
#include <vector>

namespace rockslope {

/// Checks before any work that a result file can be written: it is not a folder, its folder exists and is
/// writable (or is `created_later`, which the program makes), and it is none of `inputs` under any spelling.
/// @throws InputError.
void check_output(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs,
                  const std::filesystem::path& created_later = {});

/// Checks that a folder for results can be made, or exists and is writable. @throws InputError.
void check_output_folder(const std::filesystem::path& folder);
/// Makes the folder and its parents where absent. @throws InputError.
void make_output_folder(const std::filesystem::path& folder);

/// Checks that no two results are the same file under any spelling. Empty paths are skipped.
/// @throws InputError.
void check_distinct(const std::vector<std::filesystem::path>& results);

}  // namespace rockslope
