#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace rockslope {

/// A folder of published records, joint maps or curves that may not be redistributed with the project:
/// $DDA_SHARED/<name>, or shared/<name> beside a parent folder of the sources; nothing if there is none.
inline std::optional<std::filesystem::path> external_data(const std::string& name) {
    namespace fs = std::filesystem;
    if (const char* shared = std::getenv("DDA_SHARED")) {
        const fs::path folder = fs::path(shared) / name;
        return fs::exists(folder) ? std::optional(folder) : std::nullopt;
    }
    for (fs::path folder = fs::absolute(__FILE__).parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
        if (fs::exists(folder.parent_path() / "shared" / name)) return folder.parent_path() / "shared" / name;
    return std::nullopt;
}

/// The reason for skipping a test that needs the data.
inline std::string external_data_missing(const std::string& name) {
    return "external data, which may not be redistributed; set DDA_SHARED to the folder that contains " +
           name;
}

}  // namespace rockslope
