#include "support/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace rockslope::tool_support {

namespace {

/// Opens what cannot be read on a closed standard input, and what cannot be written on a closed output.
void occupy_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
        // The lowest free number is this one.
        if (::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream) ::_exit(1);
    }
}

}  // namespace

int run_program(const std::string& program, FunctionRef<int()> body) {
    occupy_closed_streams();
    std::signal(SIGPIPE, SIG_IGN);
    const int code = body();
    errno = 0;
    const bool is_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (is_written || code != 0) return code;
    std::fprintf(stderr, "%s: the standard output cannot be written%s%s\n", program.c_str(),
                 errno != 0 ? ": " : "", errno != 0 ? std::strerror(errno) : "");
    return 1;
}

}  // namespace rockslope::tool_support
