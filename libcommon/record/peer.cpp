#include <algorithm>
#include <charconv>

#include "common/base/text.hpp"
#include "record/record_format.hpp"

namespace rockslope::record {

namespace {

constexpr std::size_t peer_header_lines = 4;
constexpr std::size_t kind_line = 2;   // "ACCELERATION TIME SERIES IN UNITS OF G"
constexpr std::size_t count_line = 3;  // NPTS and DT, in three spellings

struct Sampling {
    std::size_t count = 0;
    double dt = 0;
};

/// The word after `key` (and an '='), without a trailing comma; empty when the key is absent.
std::string_view value_after(const std::vector<std::string_view>& words, std::string_view key) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
        if (lower_case(words[i]) == key) return words[i + 1];
    return {};
}

/// NPTS and DT from "NPTS=   7999, DT=   .0050 SEC," or "4096    0.0100    NPTS, DT".
std::optional<Sampling> sampling_of(std::string_view line) {
    const auto words = words_of(line, " \t=,");
    if (words.size() < 4) return std::nullopt;
    const bool numbers_first = lower_case(words[2]) == "npts";
    const std::string_view count_text = numbers_first ? words[0] : value_after(words, "npts");
    const std::string_view dt_text = numbers_first ? words[1] : value_after(words, "dt");
    Sampling sampling;
    const auto [end, error] =
        std::from_chars(count_text.data(), count_text.data() + count_text.size(), sampling.count);
    const auto dt = parse_number(dt_text);
    if (error != std::errc{} || end != count_text.data() + count_text.size() || !dt) return std::nullopt;
    sampling.dt = *dt;
    return sampling;
}

std::string unit_of(std::string_view line) {
    const auto words = words_of(line, " \t,.");
    for (std::size_t i = 0; i + 2 < words.size(); ++i)
        if (lower_case(words[i]) == "units" && lower_case(words[i + 1]) == "of")
            return std::string(words[i + 2]);
    return {};
}

/// The free-format numbers after the header; text after the last of them is ignored.
std::vector<double> numbers_of(const RecordLines& lines, std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = peer_header_lines; i < lines.size(); ++i) {
        for (const std::string_view word : words_of(lines[i])) {
            const auto value = sample_number(word);
            if (!value && values.size() == count) return values;
            if (!value)
                lines.fail(
                    i, "'" + std::string(word) + "' is not a finite number",
                    "value " + std::to_string(values.size() + 1) + " of NPTS = " + std::to_string(count));
            if (values.size() == count)
                lines.fail(i, "there are more values than the header says",
                           "NPTS = " + std::to_string(count) + " values");
            values.push_back(*value);
        }
    }
    if (values.size() < count)
        lines.fail(lines.size() - 1, "the record ends after " + std::to_string(values.size()) + " values",
                   "NPTS = " + std::to_string(count) + " values");
    return values;
}

bool is_peer(const RecordLines& lines) {
    if (lines.size() < peer_header_lines) return false;
    const auto words = words_of(lines[kind_line]);
    return !words.empty() && quantity_of_name(words.front()) && !unit_of(lines[kind_line]).empty();
}

Record read_peer(const RecordLines& lines, const RecordDeclaration& declaration) {
    if (!is_peer(lines))
        lines.fail(std::min(kind_line, std::max<std::size_t>(lines.size(), 1) - 1), "there is no PEER header",
                   "line 3 such as ACCELERATION TIME SERIES IN UNITS OF G");
    const auto sampling = sampling_of(lines[count_line]);
    if (!sampling)
        lines.fail(count_line, "the number of points and the time step are missing",
                   "\"NPTS= 7999, DT= .0050 SEC\" or \"4096 0.0100 NPTS, DT\"");
    if (sampling->count < 2)
        lines.fail(count_line, "NPTS is " + std::to_string(sampling->count), "at least 2 values");
    if (sampling->dt <= 0)
        lines.fail(count_line, "the time step is " + shortest_text(sampling->dt), "a positive time in s");
    check_sampling(sampling->dt, sampling->count, lines, count_line);
    Record record{sampling->dt, numbers_of(lines, sampling->count), {}};
    resolve_units(record, quantity_of_name(words_of(lines[kind_line]).front()), unit_of(lines[kind_line]),
                  declaration, lines, kind_line);
    return record;
}

}  // namespace

const RecordFormat peer_format{"peer", "PEER (AT2, VT2, DT2)", false, is_peer, read_peer};

}  // namespace rockslope::record
