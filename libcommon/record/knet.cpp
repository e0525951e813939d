// K-NET and KiK-net format of NIED: 17 header lines with values from column 19 on, then counts, eight to a
// line.

#include <cmath>
#include <numeric>

#include "common/base/text.hpp"
#include "record/fixed_fields.hpp"
#include "record/record_format.hpp"

namespace rockslope::record {

namespace {

constexpr std::size_t knet_header_lines = 17;
constexpr std::size_t value_column = 18;
constexpr FieldLayout counts_layout{8, 9};

struct KnetHeaderValue {
    std::size_t line = 0;
    std::string_view text;
};

KnetHeaderValue knet_header_value(const RecordLines& lines, std::string_view key) {
    for (std::size_t i = 0; i < std::min(knet_header_lines, lines.size()); ++i)
        if (lines[i].starts_with(key) && lines[i].size() > value_column)
            return {i, trimmed(lines[i].substr(value_column))};
    lines.fail(0, "the header has no '" + std::string(key) + "'", "a K-NET header of 17 lines");
}

/// A positive header value, with or without `unit` after it.
double positive_value(const RecordLines& lines, std::string_view key, std::string_view unit) {
    const KnetHeaderValue value = knet_header_value(lines, key);
    std::string_view text = value.text;
    if (text.ends_with(unit)) text.remove_suffix(unit.size());
    const auto number = field_number(text);
    if (!number || *number <= 0)
        lines.fail(value.line, "'" + std::string(value.text) + "' is not a valid " + std::string(key),
                   "a positive number", value_column + 1);
    return *number;
}

/// The acceleration of one count, gal, from "3920(gal)/6182761".
double scale_factor(const RecordLines& lines) {
    constexpr std::string_view unit = "(gal)/";
    const KnetHeaderValue value = knet_header_value(lines, "Scale Factor");
    const std::size_t at = value.text.find(unit);
    if (at != std::string_view::npos) {
        const auto above = field_number(value.text.substr(0, at));
        const auto below = field_number(value.text.substr(at + unit.size()));
        if (above && below && *above > 0 && *below > 0) return *above / *below;
    }
    lines.fail(value.line, "'" + std::string(value.text) + "' is not a scale factor",
               "a scale factor such as 3920(gal)/6182761", value_column + 1);
}

bool is_knet(const RecordLines& lines) {
    if (lines.size() < knet_header_lines || !lines[0].starts_with("Origin Time")) return false;
    for (std::size_t i = 1; i < knet_header_lines; ++i)
        if (lines[i].starts_with("Scale Factor")) return true;
    return false;
}

Record read_knet(const RecordLines& lines, const RecordDeclaration& declaration) {
    const double frequency = positive_value(lines, "Sampling Freq", "Hz");
    const double duration = positive_value(lines, "Duration Time", "s");
    const std::size_t line = knet_header_value(lines, "Duration Time").line;
    const double samples = std::round(frequency * duration);
    if (!(samples >= 2 && samples < 1e9))
        lines.fail(line, "a duration of " + shortest_text(duration) + " s gives too few or too many samples",
                   "at least 2 samples and fewer than 1e9");
    const std::size_t count = samples;
    const double scale = scale_factor(lines);
    Record record{1 / frequency, fixed_fields(lines, knet_header_lines, count, counts_layout, "record"), {}};
    check_sampling(record.dt, count, lines, line);
    expect_block_end(lines, knet_header_lines + counts_layout.lines_of(count), count);

    // The counts contain the offset of the digitiser. Max. Acc. in the header is without it.
    const double mean =
        std::accumulate(record.values.begin(), record.values.end(), 0.0) / static_cast<double>(count);
    for (double& value : record.values) value = (value - mean) * scale;
    resolve_units(record, Quantity::acceleration, "gal", declaration, lines,
                  knet_header_value(lines, "Scale Factor").line);
    return record;
}

}  // namespace

const RecordFormat knet_format{"knet", "K-NET or KiK-net", false, is_knet, read_knet};

}  // namespace rockslope::record
