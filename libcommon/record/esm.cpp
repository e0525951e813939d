// ESM and ITACA format (.ASC): 64 lines "KEY: value", then one sample per line.

#include "common/base/text.hpp"
#include "record/fixed_fields.hpp"
#include "record/record_format.hpp"

namespace rockslope::record {

namespace {

constexpr std::size_t esm_header_lines = 64;

struct HeaderValue {
    std::size_t line = 0;
    std::string_view text;
};

std::optional<HeaderValue> find_value(const RecordLines& lines, std::string_view key) {
    for (std::size_t i = 0; i < std::min(esm_header_lines, lines.size()); ++i)
        if (lines[i].starts_with(key) && lines[i].substr(key.size()).starts_with(':'))
            return HeaderValue{i, trimmed(lines[i].substr(key.size() + 1))};
    return std::nullopt;
}

HeaderValue header_value(const RecordLines& lines, std::string_view key) {
    const auto value = find_value(lines, key);
    if (!value) lines.fail(0, "the header has no " + std::string(key), "an ESM header of 64 lines");
    return *value;
}

bool is_esm(const RecordLines& lines) {
    return find_value(lines, "SAMPLING_INTERVAL_S") && find_value(lines, "NDATA");
}

Record read_esm(const RecordLines& lines, const RecordDeclaration& declaration) {
    const HeaderValue ndata = header_value(lines, "NDATA");
    const auto count = field_count(ndata.text);
    if (!count)
        lines.fail(ndata.line, "'" + std::string(ndata.text) + "' is not a valid NDATA", "a whole number");
    check_count(*count, lines, ndata.line);
    const HeaderValue interval = header_value(lines, "SAMPLING_INTERVAL_S");
    const auto dt = field_number(interval.text);
    if (!dt)
        lines.fail(interval.line, "'" + std::string(interval.text) + "' is not a valid SAMPLING_INTERVAL_S",
                   "a time in s");
    check_sampling(*dt, *count, lines, interval.line);
    const HeaderValue type = header_value(lines, "DATA_TYPE");
    const auto quantity = quantity_of_name(type.text);
    if (!quantity)
        lines.fail(type.line, "'" + std::string(type.text) + "' is not a time history",
                   "DATA_TYPE: ACCELERATION, VELOCITY or DISPLACEMENT");
    const HeaderValue unit = header_value(lines, "UNITS");

    const FieldLayout one_a_line{1, 32};
    Record record{*dt, fixed_fields(lines, esm_header_lines, *count, one_a_line, "record"), {}};
    expect_block_end(lines, esm_header_lines + *count, *count);
    resolve_units(record, quantity, std::string(unit.text), declaration, lines, unit.line);
    return record;
}

}  // namespace

const RecordFormat esm_format{"esm", "ESM", false, is_esm, read_esm};

}  // namespace rockslope::record
