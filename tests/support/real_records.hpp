#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

/// The folder of real records, which are not part of the project: $DDA_SHARED/records or ../shared/records
/// beside the sources.
inline std::optional<std::filesystem::path> real_records() {
    namespace fs = std::filesystem;
    if (const char* shared = std::getenv("DDA_SHARED")) return fs::path(shared) / "records";
    for (fs::path folder = fs::path(__FILE__).parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
        if (fs::exists(folder.parent_path() / "shared" / "records"))
            return folder.parent_path() / "shared" / "records";
    return std::nullopt;
}
