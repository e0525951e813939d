#include <algorithm>
#include <charconv>

#include "common/base/text.hpp"
#include "record/record_format.hpp"

namespace rockslope::record {

namespace {

// The header ends with the line of NPTS and DT, the fourth in PEER's files. Others that are written for the
// same programs have text before it: "Data for El Centro 1940", "The units are (g)", "NPTS=  1559, DT= .02000
// SEC".
constexpr std::size_t longest_text_header = 40;
constexpr std::size_t usual_kind_line = 2;   // "ACCELERATION TIME SERIES IN UNITS OF G"
constexpr std::size_t usual_count_line = 3;  // NPTS and DT, in three spellings

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

/// The unit after "units of" or "units are", in brackets or not; empty when the line states none.
std::string unit_of(std::string_view line) {
    const auto words = words_of(line, " \t,.():=");
    for (std::size_t i = 0; i + 2 < words.size(); ++i) {
        const std::string second = lower_case(words[i + 1]);
        if (lower_case(words[i]) == "units" && (second == "of" || second == "are" || second == "in"))
            return std::string(words[i + 2]);
    }
    return {};
}

/// What the lines before the samples state.
struct PeerHeader {
    std::size_t count_line = 0;  ///< the last line of the header
    std::size_t kind_line = 0;   ///< the line that states the unit, or the last
    std::optional<Quantity> quantity;
    std::string unit;
};

/// Nothing when none of the first lines states NPTS and DT.
std::optional<PeerHeader> header_of(const RecordLines& lines) {
    for (std::size_t i = 0; i < std::min(longest_text_header, lines.size()); ++i) {
        if (!sampling_of(lines[i])) continue;
        PeerHeader header{i, i, std::nullopt, {}};
        for (std::size_t k = 0; k < i; ++k) {
            if (header.unit.empty()) header.unit = unit_of(lines[k]);
            if (header.kind_line == i && !header.unit.empty()) header.kind_line = k;
        }
        const auto words = words_of(lines[header.kind_line]);
        if (!words.empty()) header.quantity = quantity_of_name(words.front());
        // A unit of acceleration alone, such as g, says what the values are.
        if (!header.quantity && record_unit_factor(Quantity::acceleration, header.unit))
            header.quantity = Quantity::acceleration;
        return header;
    }
    return std::nullopt;
}

/// The free-format numbers after the header; text after the last of them is ignored.
std::vector<double> numbers_of(const RecordLines& lines, std::size_t first, std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = first; i < lines.size(); ++i) {
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
    if (header_of(lines)) return true;
    if (lines.size() <= usual_count_line) return false;
    const auto words = words_of(lines[usual_kind_line]);
    return !words.empty() && quantity_of_name(words.front()) && !unit_of(lines[usual_kind_line]).empty();
}

Record read_peer(const RecordLines& lines, const RecordDeclaration& declaration) {
    if (!is_peer(lines))
        lines.fail(std::min(usual_kind_line, std::max<std::size_t>(lines.size(), 1) - 1),
                   "there is no PEER header", "line 3 such as ACCELERATION TIME SERIES IN UNITS OF G");
    const auto header = header_of(lines);
    if (!header)
        lines.fail(usual_count_line, "the number of points and the time step are missing",
                   "\"NPTS= 7999, DT= .0050 SEC\" or \"4096 0.0100 NPTS, DT\"");
    const Sampling sampling = *sampling_of(lines[header->count_line]);
    if (sampling.count < 2)
        lines.fail(header->count_line, "NPTS is " + std::to_string(sampling.count), "at least 2 values");
    if (sampling.dt <= 0)
        lines.fail(header->count_line, "the time step is " + shortest_text(sampling.dt),
                   "a positive time in s");
    check_sampling(sampling.dt, sampling.count, lines, header->count_line);
    Record record{sampling.dt, numbers_of(lines, header->count_line + 1, sampling.count), {}};
    resolve_units(record, header->quantity, header->unit, declaration, lines, header->kind_line);
    return record;
}

}  // namespace

const RecordFormat peer_format{"peer", "PEER (AT2, VT2, DT2)", false, is_peer, read_peer};

}  // namespace rockslope::record
