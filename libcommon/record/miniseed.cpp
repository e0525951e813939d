#include <algorithm>

#include "record/record_format.hpp"

namespace rockslope::record {

/// Version 2 begins with a sequence number of six digits, a letter for the quality and a blank, version 3
/// with "MS" and a 3; both are binary.
namespace {

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

Record refuse_miniseed(const RecordLines& lines, const RecordDeclaration&) {
    throw InputError(
        {lines.file_name()},
        "is miniSEED: raw counts, which the instrument's response (StationXML) turns into motion; remove the "
        "response "
        "with the tools of the data centre or with ObsPy's remove_response, and write two columns",
        "time in s and acceleration, velocity or displacement, with their unit");
}

}  // namespace

const RecordFormat miniseed_format{"miniseed", "miniSEED", false, is_miniseed, refuse_miniseed};

}  // namespace rockslope::record
