#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace rockslope {

/// A result cannot be written. what() is one line, "path: what failed: the system's reason".
class OutputError : public std::runtime_error {
  public:
    OutputError(const std::filesystem::path& path, const std::string& reason)
        : std::runtime_error(path.string() + ": " + reason) {}
};

}  // namespace rockslope
