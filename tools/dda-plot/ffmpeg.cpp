#include "ffmpeg.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <vector>

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"
#include "common/base/text.hpp"

namespace rockslope {

namespace {

/// Options of ffmpeg for a film of an extension; empty for an unknown one.
std::vector<std::string> codec_of(const std::filesystem::path& film) {
    const std::string extension = film.extension().string();
    if (extension == ".mp4")
        return {"-c:v",    "libx264",   "-crf",       "20", "-pix_fmt",
                "yuv420p", "-movflags", "+faststart", "-f", "mp4"};
    if (extension == ".webm")
        return {"-c:v", "libvpx-vp9", "-crf", "32",       "-b:v",    "0",  "-cpu-used",
                "4",    "-row-mt",    "1",    "-pix_fmt", "yuv420p", "-f", "webm"};
    // A palette of the film's own colours, and no more pictures a second than browsers show.
    if (extension == ".gif")
        return {"-vf",
                "fps=12,scale=720:-1:flags=lanczos,split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none",
                "-f", "gif"};
    return {};
}

std::vector<std::string> command_of(const std::filesystem::path& film, const std::filesystem::path& part,
                                    const Pixels& size, double frames_per_second) {
    std::vector<std::string> command = {"ffmpeg",
                                        "-loglevel",
                                        "error",
                                        "-nostdin",
                                        "-y",
                                        "-f",
                                        "rawvideo",
                                        "-pix_fmt",
                                        "bgr0",
                                        "-s",
                                        std::to_string(size.width) + "x" + std::to_string(size.height),
                                        "-r",
                                        shortest_text(frames_per_second),
                                        "-i",
                                        "pipe:0"};
    for (const std::string& option : codec_of(film)) command.push_back(option);
    command.push_back("file:" + part.string());
    return command;
}

/// Starts a program whose standard input is `input`. @return its process, or -1 with errno.
pid_t start(const std::vector<std::string>& command, int input) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    pid_t process = -1;
    const int error = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return error == 0 ? process : -1;
}

}  // namespace

bool is_movie(const std::filesystem::path& path) {
    return !codec_of(path).empty();
}

Ffmpeg::Ffmpeg(std::filesystem::path film, const Pixels& size, double frames_per_second)
    : film_(std::move(film)), part_(film_) {
    std::signal(SIGPIPE, SIG_IGN);  // a failed ffmpeg shows as a failed write
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw OutputError(film_, "cannot be written");
    pipe_ = ends[1];
    process_ = start(command_of(film_, part_.temporary(), size, frames_per_second), ends[0]);
    const int reason = errno;
    ::close(ends[0]);
    if (process_ > 0) return;
    ::close(pipe_);
    if (reason == ENOENT)
        throw InputError({"dda-plot"}, "ffmpeg, which makes films, is not installed",
                         "the program ffmpeg on the path, of Debian's package ffmpeg");
    throw OutputError(film_, "ffmpeg cannot be started");
}

Ffmpeg::~Ffmpeg() {
    if (process_ <= 0) return;
    ::kill(process_, SIGTERM);
    wait();
}

int Ffmpeg::wait() {
    ::close(pipe_);
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

void Ffmpeg::fail() {
    const int code = wait();
    throw OutputError(film_, "is not made: ffmpeg failed with exit code " + std::to_string(code));
}

void Ffmpeg::add(const Pixels& picture) {
    const std::string& bytes = picture.bytes;
    for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t n = ::write(pipe_, bytes.data() + sent, bytes.size() - sent);
        if (n < 0 && errno != EINTR) fail();
        if (n > 0) sent += static_cast<std::size_t>(n);
    }
}

void Ffmpeg::finish() {
    const int code = wait();
    if (code != 0)
        throw OutputError(film_, "is not made: ffmpeg failed with exit code " + std::to_string(code));
    part_.put_in_place();
}

}  // namespace rockslope
