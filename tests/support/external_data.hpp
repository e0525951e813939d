#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace rockslope {

/// A folder of records, joint maps or curves that others have published and the project may not carry:
/// $DDA_SHARED/<name>, or shared/<name> beside a folder that the sources are in; nothing where there is none.
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

/// Why a test that needs them is skipped.
inline std::string external_data_missing(const std::string& name) {
    return "these are others' data, which the project may not carry; set DDA_SHARED to the folder that "
           "holds " +
           name;
}

}  // namespace rockslope
