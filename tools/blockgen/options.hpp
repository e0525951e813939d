#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/drawing/page_style.hpp"

namespace rockslope::blockgen_tool {

/// The command line of blockgen.
struct Options {
    std::filesystem::path model;
    std::filesystem::path output;
    std::optional<std::int64_t> seed;
    std::vector<std::string> overrides;
    std::filesystem::path picture, size_picture, rose_picture, stereonet_picture, kinematic_picture, report,
        depfile, geojson, vtk;
    PageStyle picture_style;
    bool verify = false;
    bool print_config = false;
    std::size_t max_blocks = 1'000'000;
    int threads = 1;
    std::string text;  ///< help, version or template to print; empty: cut the model
};

/// An invalid command line.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// @throws UsageError or InputError with a message of one line.
Options parse_options(int argc, const char* const* argv);

}  // namespace rockslope::blockgen_tool
