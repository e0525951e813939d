// GeoNet V1A and V2A formats: components in sequence, each with 16 lines of text, 40 integers (10I8), 60
// reals (10F8) and samples (10F8.1) in mm and s: acceleration, and in V2A also velocity and displacement.

#include "common/base/text.hpp"
#include "record/fixed_fields.hpp"
#include "record/record_format.hpp"
#include "record/stacked_blocks.hpp"

namespace rockslope::record {

namespace {

constexpr FieldLayout layout{10, 8};
constexpr std::size_t geonet_text_lines = 16, geonet_integers_count = 40, geonet_reals_count = 60;
constexpr std::size_t geonet_header_lines = geonet_text_lines + 4 + 6;

/// Numbers of the header entries, from 1: sample count of the first time history, and time step. In a
/// corrected record the counts of the second and third time history follow.
constexpr std::size_t raw_count = 31, corrected_count = 34, raw_step = 25, corrected_step = 26;

constexpr const char* geonet_units[] = {"mm/s2", "mm/s", "mm"};  // in the order of Quantity

struct TimeHistory {
    StackedBlock block;     // its line is the first line of the component
    std::size_t first = 0;  // index of the first line of samples
    std::size_t count = 0;
    double dt = 0;  // s
};

/// The count in line 10 of the text, "Number of points  5800", if it has this form.
std::optional<std::size_t> points_in_words(std::string_view line) {
    const auto words = words_of(line);
    if (words.size() < 4 || words[0] != "Number" || words[2] != "points") return std::nullopt;
    return field_count(words[3]);
}

std::size_t header_count(const std::vector<double>& integers, std::size_t number, const RecordLines& lines,
                         std::size_t start) {
    const std::size_t line = start + geonet_text_lines + (number - 1) / layout.per_line;
    const auto count = field_count(shortest_text(integers[number - 1]));
    if (!count) lines.fail(line, "the header has no number of points", "a whole number");
    check_count(*count, lines, line);
    return *count;
}

/// Appends the time histories of the component that begins at line `start`. @return the first line after it.
std::size_t append_component(std::vector<TimeHistory>& histories, const RecordLines& lines,
                             std::size_t start) {
    const std::size_t integers_line = start + geonet_text_lines;
    const auto integers = fixed_fields(lines, integers_line, geonet_integers_count, layout, "integer header");
    const auto reals = fixed_fields(lines, integers_line + 4, geonet_reals_count, layout, "real header");
    const bool raw = lower_case(lines[start]).starts_with("uncorrected");
    const double dt = reals[(raw ? raw_step : corrected_step) - 1];
    std::size_t line = start + geonet_header_lines;
    for (std::size_t k = 0; k < (raw ? 1u : 3u); ++k) {
        const std::size_t count = header_count(integers, raw ? raw_count : corrected_count + k, lines, start);
        const auto in_words = points_in_words(lines[start + 9]);
        if (!raw && in_words && *in_words != count)
            lines.fail(start + 9, "the text states " + std::to_string(*in_words) + " points",
                       std::to_string(count) + ", as the integer header says");
        check_sampling(dt, count, lines, start + geonet_text_lines + 6);
        histories.push_back({{start, static_cast<Quantity>(k)}, line, count, dt});
        line += layout.lines_of(count);
    }
    expect_block_end(lines, line, histories.back().count);
    return line;
}

std::vector<TimeHistory> histories_of(const RecordLines& lines) {
    std::vector<TimeHistory> histories;
    std::size_t start = 0;
    while (start < lines.size() && !trimmed(lines[start]).empty())
        start = append_component(histories, lines, start);
    return histories;
}

bool is_geonet(const RecordLines& lines) {
    if (lines.size() < geonet_header_lines || lower_case(lines[0]).find("accelerogram") == std::string::npos)
        return false;
    return has_fixed_fields(lines, geonet_text_lines, geonet_integers_count, layout) &&
           has_fixed_fields(lines, geonet_text_lines + 4, geonet_reals_count, layout);
}

Record read_geonet(const RecordLines& lines, const RecordDeclaration& declaration) {
    const std::vector<TimeHistory> histories = histories_of(lines);
    std::vector<StackedBlock> blocks;
    for (const TimeHistory& history : histories) blocks.push_back(history.block);
    const std::size_t chosen =
        static_cast<std::size_t>(&choose_block(blocks, declaration, lines) - blocks.data());
    const TimeHistory& history = histories[chosen];
    Record record{
        history.dt,
        fixed_fields(lines, history.first, history.count, layout, quantity_name(history.block.quantity)),
        {}};
    resolve_units(record, history.block.quantity, geonet_units[static_cast<int>(history.block.quantity)],
                  declaration, lines, history.block.line);
    return record;
}

}  // namespace

const RecordFormat geonet_format{"geonet", "GeoNet V1A or V2A", true, is_geonet, read_geonet};

}  // namespace rockslope::record
