#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace rockslope::recorded_step {

/// The folder of the recorded steps, which the build names.
inline std::filesystem::path recorded_folder() {
    return RECORDED_STEPS_FOLDER;
}

/// The recorded steps of the project, by name.
inline std::vector<std::filesystem::path> recorded_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(recorded_folder()))
        if (entry.path().extension() == ".step") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

inline std::string contents_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

}  // namespace rockslope::recorded_step
