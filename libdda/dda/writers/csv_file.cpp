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
    const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | (resume_from ? 0 : O_TRUNC);
    descriptor_ = ::open(path_.c_str(), flags, 0666);
    if (descriptor_ < 0) fail("cannot be written", errno);
    size_ = resume_from.value_or(0);
    const off_t end = ::lseek(descriptor_, 0, SEEK_END);
    if (end < size_)
        fail("has " + std::to_string(end) + " bytes, the checkpoint " + std::to_string(size_), 0);
    if (::ftruncate(descriptor_, size_) != 0) fail("cannot be truncated", errno);
    ::lseek(descriptor_, size_, SEEK_SET);
}

CsvFile::~CsvFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void CsvFile::fail(const std::string& what, int reason) const {
    throw OutputError(path_, reason != 0 ? what + ": " + std::strerror(reason) : what);
}

void CsvFile::append(std::string_view lines) {
    std::string_view rest = lines;
    while (!rest.empty()) {
        const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) {
            const int reason = errno;
            if (::ftruncate(descriptor_, size_) == 0) ::lseek(descriptor_, size_, SEEK_SET);
            fail("cannot be written", reason);
        }
        rest.remove_prefix(static_cast<std::size_t>(count));
    }
    size_ += static_cast<std::int64_t>(lines.size());
}

}  // namespace rockslope::dda
