#pragma once

#include <filesystem>
#include <vector>

#include "frame_picture.hpp"

namespace rockslope {

/// The times of a film.
struct MovieTiming {
    double frames_per_second = 25;
    double speed = 1;  ///< seconds of the run in a second of the film
};

/// Frames of a run that are drawn alike.
struct FrameSeries {
    const RunFrames& run;
    std::vector<std::int64_t> frames;
    PictureScale scale;
    FrameContent content;
    PageStyle style;
};

/// Writes a film of a series. Each frame is shown from its time to that of the next.
/// @throws InputError when ffmpeg is not installed, OutputError when it fails.
void write_movie(const FrameSeries& series, const MovieTiming& timing, const std::filesystem::path& film);

}  // namespace rockslope
