#include "record/record_lines.hpp"

#include <algorithm>
#include <cctype>

#include "common/base/text.hpp"

namespace rockslope::record {

RecordLines::RecordLines(std::string_view text, std::string file_name)
    : bytes_(text), file_name_(std::move(file_name)) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        while (line.ends_with('\r')) line.remove_suffix(1);  // files sent twice as text have two
        lines_.push_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

void RecordLines::fail(std::size_t index, const std::string& what, const std::string& expected,
                       std::size_t column) const {
    SourceLocation location = place(index);
    location.column = static_cast<int>(column);
    throw InputError(location, what, expected);
}

std::vector<std::string_view> words_of(std::string_view line, std::string_view separators) {
    std::vector<std::string_view> words;
    std::size_t at = line.find_first_not_of(separators);
    while (at != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(separators, end);
    }
    return words;
}

std::vector<std::string> csv_fields(std::string_view line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') {
            const bool doubled = quoted && i + 1 < line.size() && line[i + 1] == '"';
            if (doubled)
                fields.back() += line[++i];
            else
                quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += line[i];
        }
    }
    return fields;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t start = text.find_first_not_of(" \t");
    if (start == std::string_view::npos) return {};
    return text.substr(start, text.find_last_not_of(" \t") - start + 1);
}

std::optional<double> sample_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    const std::size_t exponent = text.find_first_of("Dd");
    if (exponent == std::string_view::npos) return parse_number(text);
    std::string with_e(text);
    with_e[exponent] = 'E';
    return parse_number(with_e);
}

std::string lower_case(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

}  // namespace rockslope::record
