#include "blockgen/input/csv_table.hpp"

#include <algorithm>
#include <string_view>

#include "blockgen/mesh/names.hpp"
#include "common/base/input_error.hpp"
#include "common/base/magnitude.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

struct Field {
    std::string_view text;
    int column = 1;
};

/// The first `character` that is outside double quotes, from `start` on, or the end of the line.
std::size_t find_unquoted(std::string_view line, char character, std::size_t start) {
    bool quoted = false;
    for (std::size_t i = start; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        if (line[i] == character && !quoted) return i;
    }
    return line.size();
}

/// A field without its double quotes; a doubled quote inside stands for one.
std::string unquoted(std::string_view field) {
    std::string text(field);
    for (std::size_t at = text.find("\"\""); at != std::string::npos; at = text.find("\"\"", at + 1))
        text.erase(at, 1);
    return text;
}

/// Fills `fields` with those of a line between commas outside quotes, without blanks and quotes round them.
void split(std::string_view line, std::vector<Field>& fields) {
    fields.clear();
    for (std::size_t start = 0; start <= line.size();) {
        const std::size_t comma = find_unquoted(line, ',', start);
        std::size_t first = start, last = comma;
        const auto is_blank = [&](std::size_t i) {
            return line[i] == ' ' || line[i] == '\t' || line[i] == '\r';
        };
        while (first < last && is_blank(first)) ++first;
        while (last > first && is_blank(last - 1)) --last;
        if (last - first >= 2 && line[first] == '"' && line[last - 1] == '"') ++first, --last;
        fields.push_back({line.substr(first, last - first), static_cast<int>(first) + 1});
        start = comma + 1;
    }
}

/// The lines of a file that hold anything, without their comments.
class CsvLines {
  public:
    explicit CsvLines(const std::filesystem::path& path) : text_(read_text_file(path)) {}

    /// Fills `fields` with those of the next line. @return false at the end of the file.
    bool next(std::vector<Field>& fields) {
        while (start_ < text_.size()) {
            const std::size_t newline = std::min(text_.find('\n', start_), text_.size());
            std::string_view line = std::string_view(text_).substr(start_, newline - start_);
            start_ = newline + 1;
            ++number_;
            if (number_ == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
            split(line.substr(0, find_unquoted(line, '#', 0)), fields);
            if (fields.size() != 1 || !fields[0].text.empty()) return true;
        }
        return false;
    }
    /// The number of the line that was read last.
    int number() const { return number_; }

  private:
    std::string text_;
    std::size_t start_ = 0;
    int number_ = 0;
};

constexpr std::size_t no_column = static_cast<std::size_t>(-1);

std::size_t position_of(const std::vector<Field>& header, const std::string& name) {
    for (std::size_t i = 0; i < header.size(); ++i)
        if (header[i].text == name) return i;
    return no_column;
}

std::string list_of(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

}  // namespace

bool csv_has_column(const std::filesystem::path& path, const std::string& name) {
    CsvLines lines(path);
    std::vector<Field> fields;
    return lines.next(fields) && position_of(fields, name) != no_column;
}

CsvTable read_csv(const std::filesystem::path& path, const std::vector<std::string>& number_columns,
                  const std::vector<std::string>& text_columns) {
    CsvLines lines(path);
    std::vector<std::size_t> position;  // per requested column, in a line
    CsvTable table;
    table.number_columns = number_columns.size();
    table.text_columns = text_columns.size();
    std::vector<Field> fields;
    while (lines.next(fields)) {
        const int line_number = lines.number();
        if (position.empty()) {
            const bool is_header = !parse_number(fields[0].text);
            for (std::size_t i = 0; i < number_columns.size() + text_columns.size(); ++i) {
                const bool number = i < number_columns.size();
                const std::string& name =
                    number ? number_columns[i] : text_columns[i - number_columns.size()];
                position.push_back(is_header ? position_of(fields, name) : i);
                if (is_header && number && position.back() == no_column)
                    throw InputError({path.string(), line_number, 1},
                                     "the header has no column '" + name + "'",
                                     "the columns " + list_of(number_columns));
            }
            if (is_header) continue;
        }
        table.lines.push_back(line_number);
        for (std::size_t i = 0; i < position.size(); ++i) {
            const bool present = position[i] < fields.size();
            if (i >= number_columns.size()) {
                table.texts.push_back(present ? unquoted(fields[position[i]].text) : std::string());
                if (!is_utf8(table.texts.back()))
                    throw InputError({path.string(), line_number, fields[position[i]].column},
                                     "a name is not UTF-8", "UTF-8 text");
                continue;
            }
            const auto value = present ? parse_number(fields[position[i]].text) : std::nullopt;
            if (!value)
                throw InputError(
                    {path.string(), line_number, present ? fields[position[i]].column : 1},
                    present ? "'" + std::string(fields[position[i]].text) + "' is not a finite number"
                            : "the line ends before column '" + number_columns[i] + "'",
                    "a number for " + number_columns[i]);
            if (!is_in_allowed_range(*value))
                throw InputError({path.string(), line_number, fields[position[i]].column},
                                 "'" + std::string(fields[position[i]].text) + "' is too large",
                                 "a number for " + number_columns[i]);
            table.numbers.push_back(*value);
        }
    }
    return table;
}

}  // namespace rockslope::blockgen
