// COSMOS V1.20 format: for each time history some lines of text, an integer header, a real header, comments,
// and a line such as
//   7000  acceleration pts, approx   70 secs, units=cm/sec2(04),Format=(8F10.5)
// before the samples. Every block states its layout. Fields may have no separators.

#include "record/fixed_fields.hpp"
#include "record/record_format.hpp"
#include "record/stacked_blocks.hpp"

namespace rockslope::record {

namespace {

constexpr std::size_t stage_number = 1, quantity_number = 2;  // among the integers, from 1
constexpr std::size_t step_number = 62;                       // among the reals, from 1: sample step, ms

constexpr std::string_view integer_header = "integer-header values follow";
constexpr std::string_view real_header = "real-header values follow";

bool announces(std::string_view line, std::string_view phrase) {
    return lower_case(line.substr(0, 120)).find(phrase) != std::string::npos;
}

struct Announcement {
    std::size_t count = 0;
    Quantity quantity = Quantity::acceleration;
    std::string unit;
};

std::optional<Announcement> announcement_of(std::string_view line) {
    const auto words = words_of(line.substr(0, 120), " \t,");
    if (words.size() < 4 || !words[2].starts_with("pts")) return std::nullopt;
    const auto count = field_count(words[0]);
    const auto quantity = quantity_of_abbreviation(words[1]);
    if (!count || !quantity) return std::nullopt;
    constexpr std::string_view key = "units=";
    const std::size_t at = line.find(key);
    if (at == std::string_view::npos) return Announcement{*count, *quantity, ""};
    const std::string_view unit = line.substr(at + key.size());
    return Announcement{*count, *quantity, std::string(trimmed(unit.substr(0, unit.find_first_of("(,"))))};
}

std::vector<StackedBlock> blocks_of(const RecordLines& lines) {
    std::vector<StackedBlock> blocks;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (const auto announced = announcement_of(lines[i])) blocks.push_back({i, announced->quantity});
    return blocks;
}

FieldLayout layout_at(const RecordLines& lines, std::size_t line) {
    const auto layout = stated_layout(lines[line]);
    if (!layout) lines.fail(line, "the line states no format of its numbers", "such as Format= (8F10.5)");
    return *layout;
}

/// The numbers of the last header with `phrase` above a line.
std::vector<double> header_above(const RecordLines& lines, std::size_t line, std::string_view phrase) {
    for (std::size_t i = line; i-- > 0;) {
        if (announcement_of(lines[i])) break;
        if (!announces(lines[i], phrase)) continue;
        const auto words = words_of(lines[i]);
        const auto count = field_count(words.front());
        if (!count) lines.fail(i, "the header does not say how many values follow", "a whole number");
        return fixed_fields(lines, i + 1, *count, layout_at(lines, i), "header");
    }
    lines.fail(line, "there is no line '" + std::string(phrase) + "' above the samples", "a COSMOS header");
}

double header_number(const std::vector<double>& header, std::size_t number, const RecordLines& lines,
                     std::size_t line) {
    if (number > header.size())
        lines.fail(line, "a header above has only " + std::to_string(header.size()) + " values",
                   "100 values");
    return header[number - 1];
}

bool is_cosmos(const RecordLines& lines) {
    constexpr std::size_t longest_text = 40;
    for (std::size_t i = 0; i < std::min(longest_text, lines.size()); ++i)
        if (announces(lines[i], integer_header)) return true;
    return false;
}

/// @throws InputError when the first integer header is that of a raw record: its samples need not be
/// announced as those of a corrected one.
void refuse_raw(const RecordLines& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!announces(lines[i], integer_header)) continue;
        const auto count = field_count(words_of(lines[i]).front());
        if (!count || *count == 0) return;
        if (fixed_fields(lines, i + 1, *count, layout_at(lines, i), "header")[stage_number - 1] == 0)
            lines.fail(i, "the record is raw: counts without instrument correction", "a V1 or V2 record");
        return;
    }
}

Record read_cosmos(const RecordLines& lines, const RecordDeclaration& declaration) {
    refuse_raw(lines);
    const std::size_t line = choose_block(blocks_of(lines), declaration, lines).line;
    const Announcement announced = *announcement_of(lines[line]);
    check_count(announced.count, lines, line);
    const std::vector<double> integers = header_above(lines, line, integer_header);
    const std::vector<double> reals = header_above(lines, line, real_header);
    if (header_number(integers, stage_number, lines, line) == 0 || announced.unit.starts_with("count"))
        lines.fail(line, "the record is raw: counts without instrument correction", "a V1 or V2 record");
    // 1, 2, 3 for acceleration, velocity, displacement
    const double quantity = header_number(integers, quantity_number, lines, line);
    if (quantity != 1 + static_cast<double>(announced.quantity))
        lines.fail(line, "the integer header and the line with 'pts' give different quantities",
                   "quantity 1, 2 or 3 for acceleration, velocity, displacement");
    Record record;
    record.dt = header_number(reals, step_number, lines, line) / 1000;
    check_sampling(record.dt, announced.count, lines, line);
    const FieldLayout layout = layout_at(lines, line);
    record.values = fixed_fields(lines, line + 1, announced.count, layout, quantity_name(announced.quantity));
    expect_block_end(lines, line + 1 + layout.lines_of(announced.count), announced.count);
    resolve_units(record, announced.quantity, announced.unit, declaration, lines, line);
    return record;
}

}  // namespace

const RecordFormat cosmos_format{"cosmos", "COSMOS V1.2", true, is_cosmos, read_cosmos};

}  // namespace rockslope::record
