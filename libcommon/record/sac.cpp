// SAC format, binary, in either byte order: a header of 70 reals, 40 integers (four bytes each) and 192
// characters, then NPTS reals of four bytes. Version 7 adds 22 doubles at the end. The format does not state
// the quantity of the samples.

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "common/base/text.hpp"
#include "record/record_format.hpp"

namespace rockslope::record {

namespace {

constexpr std::size_t header_bytes = 632, footer_bytes = 176;
// Words of the header, from 0.
constexpr std::size_t step_word = 0, version_word = 76, points_word = 79, type_word = 85, even_word = 105;
constexpr std::int32_t time_series = 1;  // IFTYPE

std::uint32_t word_at(std::string_view bytes, std::size_t word, bool big_endian) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto byte = static_cast<unsigned char>(bytes[4 * word + k]);
        value |= std::uint32_t{byte} << (8 * (big_endian ? 3 - k : k));
    }
    return value;
}

std::int32_t integer_at(std::string_view bytes, std::size_t word, bool big_endian) {
    return std::bit_cast<std::int32_t>(word_at(bytes, word, big_endian));
}

float real_at(std::string_view bytes, std::size_t word, bool big_endian) {
    return std::bit_cast<float>(word_at(bytes, word, big_endian));
}

/// The byte order in which the header version is 6 or 7; nothing if there is none.
std::optional<bool> is_big_endian(std::string_view bytes) {
    if (bytes.size() < header_bytes) return std::nullopt;
    for (const bool big : {false, true}) {
        const std::int32_t version = integer_at(bytes, version_word, big);
        if (version == 6 || version == 7) return big;
    }
    return std::nullopt;
}

/// The shortest decimal number that rounds to the float: 0.02, not 0.0199999996.
double decimal(float value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return parse_number({text.data(), end}).value_or(0);
}

[[noreturn]] void fail(const RecordLines& lines, const std::string& what, const std::string& expected) {
    throw InputError({lines.file_name()}, what, expected);
}

/// The number of samples in the header. @throws InputError if the file size does not match it.
std::size_t checked_count(const RecordLines& lines, bool big) {
    const std::string_view bytes = lines.bytes();
    const std::int32_t points = integer_at(bytes, points_word, big);
    if (points < 2) fail(lines, "NPTS is " + std::to_string(points), "at least 2 samples");
    const std::size_t footer = integer_at(bytes, version_word, big) == 7 ? footer_bytes : 0;
    const std::size_t expected_size = header_bytes + 4 * static_cast<std::size_t>(points) + footer;
    if (bytes.size() != expected_size)
        fail(lines,
             "the file has " + std::to_string(bytes.size()) + " bytes" +
                 (bytes.size() < expected_size ? ": it is cut off" : ": there are more than the header says"),
             std::to_string(expected_size) + " for NPTS = " + std::to_string(points));
    return points;
}

bool is_sac(const RecordLines& lines) {
    const auto big = is_big_endian(lines.bytes());
    if (!big) return false;
    const std::int32_t even = integer_at(lines.bytes(), even_word, *big);
    const std::int32_t type = integer_at(lines.bytes(), type_word, *big);
    constexpr std::int32_t last_type = 200;  // beyond all codes of the header
    return (even == 0 || even == 1) && type >= 1 && type < last_type;
}

Record read_sac(const RecordLines& lines, const RecordDeclaration& declaration) {
    const std::string_view bytes = lines.bytes();
    const auto big = is_big_endian(bytes);
    if (!big) fail(lines, "there is no SAC header", "632 bytes, version 6 or 7");
    if (integer_at(bytes, type_word, *big) != time_series) fail(lines, "is not a time series", "IFTYPE = 1");
    if (integer_at(bytes, even_word, *big) != 1) fail(lines, "the time step is uneven", "LEVEN = 1");
    const std::size_t count = checked_count(lines, *big);
    Record record{decimal(real_at(bytes, step_word, *big)), {}, {}};
    check_sampling(record.dt, count, lines, 0);
    record.values.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        const float value = real_at(bytes, header_bytes / 4 + k, *big);
        if (!std::isfinite(value))
            fail(lines, "sample " + std::to_string(k + 1) + " is not finite", "finite numbers");
        record.values.push_back(value);
    }
    resolve_units(record, std::nullopt, "", declaration, lines, 0);
    return record;
}

}  // namespace

const RecordFormat sac_format{"sac", "SAC", false, is_sac, read_sac};

}  // namespace rockslope::record
