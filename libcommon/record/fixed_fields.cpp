#include "record/fixed_fields.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace rockslope::record {

namespace {

constexpr double largest_count = 1e9;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Reads a whole number of at most three digits at `at`, and moves `at` behind it.
std::size_t small_number(std::string_view text, std::size_t& at) {
    std::size_t number = 0;
    for (int digits = 0; at < text.size() && is_digit(text[at]) && digits < 3; ++at, ++digits)
        number = 10 * number + static_cast<std::size_t>(text[at] - '0');
    return number;
}

bool is_blank(std::string_view text) {
    return trimmed(text).empty();
}

}  // namespace

std::optional<FieldLayout> stated_layout(std::string_view line) {
    for (std::size_t open = line.find('('); open != std::string_view::npos; open = line.find('(', open + 1)) {
        std::size_t at = open + 1;
        FieldLayout layout;
        layout.per_line = small_number(line, at);
        if (at >= line.size() || std::string_view("IiFfEeGgDd").find(line[at]) == std::string_view::npos)
            continue;
        layout.width = small_number(line, ++at);
        if (layout.per_line > 0 && layout.width > 0) return layout;
    }
    return std::nullopt;
}

std::optional<double> field_number(std::string_view field) {
    return sample_number(trimmed(field));
}

std::optional<std::size_t> field_count(std::string_view field) {
    const auto number = field_number(field);
    if (!number || *number < 0 || *number >= largest_count || *number != std::floor(*number))
        return std::nullopt;
    return *number;
}

std::vector<double> fixed_fields(const RecordLines& lines, std::size_t first, std::size_t count,
                                 FieldLayout layout, const std::string& what) {
    if (first + layout.lines_of(count) > lines.size()) {
        const std::size_t complete = lines.size() > first ? (lines.size() - first) * layout.per_line : 0;
        lines.fail(std::max<std::size_t>(lines.size(), 1) - 1,
                   "the text ends within the " + what + ", before value " +
                       std::to_string(std::min(complete, count - 1) + 1),
                   std::to_string(count) + " values");
    }
    std::vector<double> values;
    values.reserve(count);
    for (std::size_t index = first; values.size() < count; ++index) {
        std::string_view rest = lines[index];
        for (std::size_t k = 0; k < layout.per_line && values.size() < count; ++k) {
            const std::string_view field = rest.substr(0, layout.width);
            const auto value = field_number(field);
            if (!value)
                lines.fail(
                    index,
                    is_blank(field) ? "a number is missing" : "'" + std::string(field) + "' is not a number",
                    "value " + std::to_string(values.size() + 1) + " of " + std::to_string(count) +
                        " of the " + what,
                    k * layout.width + 1);
            values.push_back(*value);
            rest.remove_prefix(field.size());
        }
        if (!is_blank(rest))
            lines.fail(index, "there is text after the last number",
                       values.size() == count
                           ? "the end of the " + what + ", " + std::to_string(count) + " values"
                           : std::to_string(layout.per_line) + " numbers of " + std::to_string(layout.width) +
                                 " characters",
                       lines[index].size() - rest.size() + 1);
    }
    return values;
}

void expect_block_end(const RecordLines& lines, std::size_t index, std::size_t count) {
    if (index >= lines.size()) return;
    const auto words = words_of(lines[index]);
    if (!words.empty() && std::all_of(words.begin(), words.end(),
                                      [](std::string_view w) { return field_number(w).has_value(); }))
        lines.fail(index, "there are more values than the header says", std::to_string(count) + " values");
}

bool has_fixed_fields(const RecordLines& lines, std::size_t first, std::size_t count, FieldLayout layout) {
    if (first + layout.lines_of(count) > lines.size()) return false;
    for (std::size_t k = 0; k < count; ++k) {
        const std::string_view line = lines[first + k / layout.per_line];
        const std::size_t start = k % layout.per_line * layout.width;
        if (start >= line.size() || !field_number(line.substr(start, layout.width))) return false;
    }
    return true;
}

void check_count(std::size_t count, const RecordLines& lines, std::size_t index) {
    if (count < 2)
        lines.fail(index, "the header states " + std::to_string(count) + " values", "at least 2 values");
}

}  // namespace rockslope::record
