// USGS SMC format: 11 lines of text, 48 integers (8I10), 50 reals (5E15.7), comment lines that begin with
// '|', then the samples in cm and s, in fields of ten characters without separators.

#include <cmath>

#include "common/base/text.hpp"
#include "record/fixed_fields.hpp"
#include "record/record_format.hpp"

namespace rockslope::record {

namespace {

constexpr std::size_t smc_text_lines = 11;
constexpr FieldLayout integers_layout{8, 10}, reals_layout{5, 15}, samples_layout{8, 10};
constexpr std::size_t smc_integers_count = 48, smc_reals_count = 50;
constexpr std::size_t reals_line = smc_text_lines + 6, comments_line = reals_line + 10;
constexpr std::size_t comments_number = 16, points_number = 17;  // among the integers, from 1
constexpr std::size_t frequency_number = 2;                      // among the reals, from 1: samples per s
constexpr double largest_frequency = 1e6;                        // Hz; larger values mean "not known"

constexpr const char* smc_units[] = {"cm/s2", "cm/s", "cm"};  // in the order of Quantity

/// The quantity in the title "2 CORRECTED ACCELEROGRAM", "3 VELOCITY" or "4 DISPLACEMENT".
std::optional<Quantity> quantity_of_title(std::string_view title) {
    for (const std::string_view word : words_of(title)) {
        if (lower_case(word) == "accelerogram") return Quantity::acceleration;
        if (const auto quantity = quantity_of_name(word)) return quantity;
    }
    return std::nullopt;
}

std::size_t header_count(const std::vector<double>& integers, std::size_t number, const RecordLines& lines,
                         const char* what) {
    const auto count = field_count(shortest_text(integers[number - 1]));
    if (!count)
        lines.fail(smc_text_lines + (number - 1) / integers_layout.per_line,
                   std::string("the header has no number of ") + what, "a whole number");
    return *count;
}

/// The line of the first sample, after the comments.
std::size_t samples_line(const RecordLines& lines, std::size_t comments) {
    for (std::size_t i = comments_line; i < comments_line + comments; ++i)
        if (i >= lines.size() || !lines[i].starts_with('|'))
            lines.fail(std::min(i, lines.size() - 1), "there are fewer comment lines than the header says",
                       std::to_string(comments) + " lines that begin with '|'");
    return comments_line + comments;
}

bool is_smc(const RecordLines& lines) {
    return lines.size() > comments_line && quantity_of_title(lines[0]) &&
           has_fixed_fields(lines, smc_text_lines, smc_integers_count, integers_layout) &&
           has_fixed_fields(lines, reals_line, smc_reals_count, reals_layout);
}

Record read_smc(const RecordLines& lines, const RecordDeclaration& declaration) {
    const auto integers =
        fixed_fields(lines, smc_text_lines, smc_integers_count, integers_layout, "integer header");
    const auto reals = fixed_fields(lines, reals_line, smc_reals_count, reals_layout, "real header");
    const auto quantity = quantity_of_title(lines[0]);
    if (!quantity)
        lines.fail(0, "'" + std::string(trimmed(lines[0])) + "' is not a time history",
                   "an accelerogram, a velocity or a displacement");
    const std::size_t points_line = smc_text_lines + (points_number - 1) / integers_layout.per_line;
    const std::size_t count = header_count(integers, points_number, lines, "points");
    check_count(count, lines, points_line);
    const double frequency = reals[frequency_number - 1];
    if (!(frequency > 0 && frequency <= largest_frequency))
        lines.fail(reals_line, "the sampling rate is " + shortest_text(frequency) + " Hz",
                   "a positive rate of at most 1e6 Hz", reals_layout.width + 1);
    check_sampling(1 / frequency, count, lines, reals_line);
    const std::size_t first =
        samples_line(lines, header_count(integers, comments_number, lines, "comment lines"));
    Record record{1 / frequency, fixed_fields(lines, first, count, samples_layout, "record"), {}};
    expect_block_end(lines, first + samples_layout.lines_of(count), count);
    resolve_units(record, quantity, smc_units[static_cast<int>(*quantity)], declaration, lines, 0);
    return record;
}

}  // namespace

const RecordFormat smc_format{"smc", "USGS SMC", false, is_smc, read_smc};

}  // namespace rockslope::record
