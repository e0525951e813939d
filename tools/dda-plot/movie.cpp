#include "movie.hpp"

#include <cmath>

#include "ffmpeg.hpp"

namespace rockslope {

namespace {

/// Width of a film, pixels, and of the rest at its end, s.
constexpr double film_width = 1280, rest_at_end = 1;

/// Pictures of a frame that starts and ends at these times of the run.
std::int64_t picture_count(double from, double to, const MovieTiming& timing) {
    const double per_second = timing.frames_per_second / timing.speed;
    return std::llround(to * per_second) - std::llround(from * per_second);
}

}  // namespace

void write_movie(const FrameSeries& series, const MovieTiming& timing, const std::filesystem::path& film) {
    const std::vector<std::int64_t>& frames = series.frames;
    const std::vector<double>& times = series.run.times();
    const auto pixels_of = [&](std::int64_t index) {
        const Canvas canvas = draw_frame(series.run, index, series.scale, series.content, series.style);
        return canvas.pixels(film_width / canvas.width());
    };
    Ffmpeg ffmpeg(film, pixels_of(frames.front()), timing.frames_per_second);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const double from = times[static_cast<std::size_t>(frames[k])];
        const bool is_last = k + 1 == frames.size();
        const double to =
            is_last ? from + rest_at_end * timing.speed : times[static_cast<std::size_t>(frames[k + 1])];
        const std::int64_t count = picture_count(from, to, timing);
        if (count == 0) continue;
        const Pixels picture = pixels_of(frames[k]);
        for (std::int64_t i = 0; i < count; ++i) ffmpeg.add(picture);
    }
    ffmpeg.finish();
}

}  // namespace rockslope
