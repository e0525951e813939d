#include "dda/writers/csv_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>

#include "common/base/output_error.hpp"
#include "common/base/text.hpp"

namespace rockslope::dda {

CsvRow& CsvRow::field(std::string_view value) {
    if (!first_) line_ += ',';
    first_ = false;
    line_ += value;
    return *this;
}

CsvRow& CsvRow::text(std::string_view value) {
    if (value.find_first_of(",\"\r\n") == std::string_view::npos) return field(value);
    std::string quoted = "\"";
    for (const char c : value) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return field(quoted + '"');
}

CsvRow& CsvRow::integer(std::int64_t value) {
    return field(std::to_string(value));
}

CsvRow& CsvRow::number(double value, std::string_view what) {
    if (!std::isfinite(value))
        throw OutputError(path_, std::string(what) + " is not finite; the row is not written");
    return field(shortest_text(value));
}

CsvFile::CsvFile(std::filesystem::path path, std::optional<std::int64_t> resume_from)
    : path_(std::move(path)) {
    const int flags = O_RDWR | O_CREAT | O_CLOEXEC | (resume_from ? 0 : O_TRUNC);
    descriptor_ = ::open(path_.c_str(), flags, 0666);
    if (descriptor_ < 0) fail("cannot be written", errno);
    size_ = resume_from.value_or(0);
    old_size_ = ::lseek(descriptor_, 0, SEEK_END);
    if (old_size_ < size_)
        fail("has " + std::to_string(old_size_) + " bytes, the checkpoint " + std::to_string(size_), 0);
    if (size_ > 0) written_ = sha256_of_beginning(path_, static_cast<std::uintmax_t>(size_));
}

CsvFile::~CsvFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void CsvFile::fail(const std::string& what, int reason) const {
    throw OutputError(path_, reason != 0 ? what + ": " + std::strerror(reason) : what);
}

/// Whether the file goes on with these lines.
bool CsvFile::has_next(std::string_view lines) const {
    if (size_ + static_cast<std::int64_t>(lines.size()) > old_size_) return false;
    std::string found(lines.size(), '\0');
    return ::pread(descriptor_, found.data(), found.size(), size_) == static_cast<ssize_t>(found.size()) &&
           found == lines;
}

void CsvFile::cut() {
    if (size_ < old_size_ && ::ftruncate(descriptor_, size_) != 0) fail("cannot be truncated", errno);
    old_size_ = 0;
}

void CsvFile::sync() {
    if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) fail("cannot be written", errno);
}

void CsvFile::append(std::string_view lines) {
    if (!has_next(lines)) {
        cut();
        write_at_end(lines);
    }
    written_.add(lines);
    size_ += static_cast<std::int64_t>(lines.size());
}

void CsvFile::write_at_end(std::string_view lines) {
    std::int64_t end = size_;
    while (!lines.empty()) {
        const ssize_t count = ::pwrite(descriptor_, lines.data(), lines.size(), end);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) {
            const int reason = errno;
            // What cannot be removed is cut off, or written again, by a resumed run.
            if (::ftruncate(descriptor_, size_) != 0) old_size_ = end;
            fail("cannot be written", reason);
        }
        lines.remove_prefix(static_cast<std::size_t>(count));
        end += count;
    }
}

}  // namespace rockslope::dda
