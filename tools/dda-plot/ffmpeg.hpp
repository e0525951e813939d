#pragma once

#include <sys/types.h>

#include <filesystem>

#include "common/base/atomic_file.hpp"
#include "common/drawing/canvas.hpp"

namespace rockslope {

/// Whether dda-plot can make a film of a file's extension: .mp4, .webm or .gif.
bool is_movie(const std::filesystem::path& path);

/// The program ffmpeg, which makes a film of the pictures that it is given one after the other. The film has
/// another name until it is complete.
class Ffmpeg {
  public:
    /// Starts ffmpeg. @param size of every picture; its bytes do not matter. @throws InputError when ffmpeg
    /// is not installed.
    Ffmpeg(std::filesystem::path film, const Pixels& size, double frames_per_second);
    /// Ends ffmpeg and removes a film that is not complete.
    ~Ffmpeg();
    Ffmpeg(const Ffmpeg&) = delete;
    Ffmpeg& operator=(const Ffmpeg&) = delete;

    /// Adds a picture. @throws OutputError when ffmpeg has failed.
    void add(const Pixels& picture);
    /// Completes the film. @throws OutputError when ffmpeg has failed.
    void finish();

  private:
    [[noreturn]] void fail();
    int wait();

    std::filesystem::path film_;
    PendingFile part_;  ///< ffmpeg writes into it
    pid_t process_ = -1;
    int pipe_ = -1;
};

}  // namespace rockslope
