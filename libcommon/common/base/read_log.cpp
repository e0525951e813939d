#include "common/base/read_log.hpp"

#include <algorithm>

#include "common/base/input_error.hpp"
#include "common/base/sha256.hpp"

namespace rockslope {

namespace {

/// The innermost log of this thread.
thread_local ReadLog* present = nullptr;

}  // namespace

ReadLog::ReadLog() : outer_(present) {
    present = this;
}

ReadLog::~ReadLog() {
    present = outer_;
}

std::string ReadLog::digest_of(const std::filesystem::path& path) const {
    const auto file =
        std::find_if(files_.begin(), files_.end(), [&](const InputFile& f) { return f.path == path; });
    return file == files_.end() ? std::string() : file->sha256;
}

void ReadLog::add(const std::filesystem::path& path, std::string_view bytes) {
    if (present == nullptr) return;
    const std::string digest = sha256(bytes);
    for (ReadLog* log = present; log != nullptr; log = log->outer_) {
        const std::string known = log->digest_of(path);
        if (known.empty()) log->files_.push_back({path, digest});
        if (!known.empty() && known != digest)
            throw InputError({path.string()}, "changed while it was read", "a file that stays as it is");
    }
}

}  // namespace rockslope
