#pragma once

#include <filesystem>
#include <vector>

namespace rockslope {

/// Refuses a result file before any work is done: it must be no folder, its folder must be there (or be
/// `created_later`, a folder that the program makes) and writable, and it must be none of `inputs` under any
/// spelling. @throws InputError.
void check_output(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs,
                  const std::filesystem::path& created_later = {});

/// Refuses a folder for results that can neither be written nor made. @throws InputError.
void check_output_folder(const std::filesystem::path& folder);
/// Makes it. @throws InputError.
void make_output_folder(const std::filesystem::path& folder);

/// Refuses two results of one name, under any spelling; empty paths are skipped. @throws InputError.
void check_distinct(const std::vector<std::filesystem::path>& results);

}  // namespace rockslope
