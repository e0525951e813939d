#pragma once

#include <filesystem>

namespace rockslope {

/// Writes a page that shows a run, in one file that needs no network and no other file: the slide as a film
/// that plays, histories, tables and checks. @param report name of the page, .html. @throws InputError for
/// results that cannot be read, OutputError when the page cannot be written.
void write_report(const std::filesystem::path& folder, const std::filesystem::path& report);

}  // namespace rockslope
