#include "run_log.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "common/base/output_check.hpp"
#include "common/base/output_error.hpp"

namespace rockslope {

namespace {

std::string last_line(const std::filesystem::path& file) {
    std::ifstream text(file);
    std::string line, last;
    while (std::getline(text, line))
        if (!line.empty()) last = line;
    return last;
}

/// Takes room for the line that tells why the run failed: a full disk has none left for it then.
void reserve_last_line(int log, const std::filesystem::path& file) {
    constexpr off_t room = 4096;
    if (::fallocate(log, FALLOC_FL_KEEP_SIZE, 0, room) != 0 && errno == ENOSPC)
        throw OutputError(file, std::string("cannot be written: ") + std::strerror(errno));
}

}  // namespace

RunLog::RunLog(const std::filesystem::path& folder, std::string title)
    : folder_(folder), title_(std::move(title)) {
    make_output_folder(folder_);
    const std::filesystem::path file = folder_ / "log";
    const int log = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
    if (log < 0) throw OutputError(file, std::string("cannot be written: ") + std::strerror(errno));
    reserve_last_line(log, file);
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    std::ofstream(folder_ / "running") << host.data() << " " << ::getpid() << "\n";
    std::printf("%s\n", title_.c_str());
    std::fflush(stdout);
    errors_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // in order with the standard error
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    ::close(log);
}

void RunLog::finish(int code) const {
    std::fflush(stdout);
    std::error_code ignored;
    std::filesystem::resize_file(folder_ / "running", 0, ignored);
    if (code != 0) ::dprintf(errors_, "%s: %s\n", title_.c_str(), last_line(folder_ / "log").c_str());
}

}  // namespace rockslope
