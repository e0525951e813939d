#pragma once

#include <boost/program_options.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "movie.hpp"
#include "support/command_page.hpp"

namespace rockslope {

/// The command line of dda-plot.
struct PlotOptions {
    std::vector<std::filesystem::path> folders, references;
    std::filesystem::path output;
    std::optional<std::string> frames;  ///< list of frames
    std::optional<double> largest;      ///< SI unit of the field
    std::optional<std::string> joint;
    std::optional<std::filesystem::path> movie, report;
    bool history = false, roughness = false, worst_contact = false;
    bool draws_all = false;  ///< no option chooses pictures: all kinds are drawn
    std::string extension;   ///< of the pictures
    FrameContent content;
    PageStyle style;
    MovieTiming timing;
};

/// What dda-plot says of itself, with its options.
tool_support::CommandPage command_page();

/// The options of a command line; values that cannot be are refused. @throws InputError.
PlotOptions read_options(const boost::program_options::variables_map& values);

/// The frames of a list such as "0,middle,last", of `count` frames. @throws InputError.
std::vector<std::int64_t> frame_numbers(const std::string& list, std::int64_t count);

}  // namespace rockslope
