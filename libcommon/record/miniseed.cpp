#include <algorithm>

#include "record/record_format.hpp"

namespace rockslope::record {

namespace {

/// Version 2 begins with a sequence number of six digits, a quality letter and a blank; version 3 begins with
/// "MS" and a byte 3. Both are binary.
bool is_miniseed(const RecordLines& lines) {
    const std::string_view bytes = lines.bytes();
    constexpr std::size_t fixed_header = 40;
    if (bytes.size() < fixed_header) return false;
    if (bytes.starts_with("MS\x03")) return true;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    return std::all_of(bytes.begin(), bytes.begin() + 6, is_digit) &&
           std::string_view("DRQM").find(bytes[6]) != std::string_view::npos &&
           (bytes[7] == ' ' || bytes[7] == '\0') &&
           bytes.substr(0, 4096).find('\0') != std::string_view::npos;
}

Record reject_miniseed(const RecordLines& lines, const RecordDeclaration&) {
    throw InputError(
        {lines.file_name()},
        "is miniSEED: raw counts without the instrument response (StationXML); remove the response with the "
        "tools of the data centre or with ObsPy's remove_response, and write two columns",
        "time in s and acceleration, velocity or displacement, with their unit");
}

}  // namespace

const RecordFormat miniseed_format{"miniseed", "miniSEED", false, is_miniseed, reject_miniseed};

}  // namespace rockslope::record
