#include "study/csv/csv_text.hpp"

#include "common/base/input_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"

namespace rockslope::study {

namespace {

/// Splits CSV text into records, one call each.
class CsvReader {
  public:
    CsvReader(std::string_view text, const std::filesystem::path& file) : text_(text), file_(file) {}

    bool at_end() const { return at_ >= text_.size(); }
    int line() const { return line_; }
    std::vector<std::string> record() {
        std::vector<std::string> fields;
        do {
            fields.push_back(field());
        } while (take(','));
        take('\r');
        if (!at_end() && !take('\n')) fail("has text after a quoted field", "a comma or the end of the line");
        ++line_;
        return fields;
    }
    [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
        throw InputError({file_.string(), line_}, what, expected);
    }

  private:
    bool take(char c) {
        if (at_end() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    std::string field() {
        std::string value;
        if (!take('"')) {
            while (!at_end() && text_[at_] != ',' && text_[at_] != '\n' && text_[at_] != '\r')
                value += text_[at_++];
            return value;
        }
        while (true) {
            if (at_end()) fail("has a quote that is not closed", "a closing quote");
            const char c = text_[at_++];
            if (c == '\n') ++line_;
            if (c != '"')
                value += c;
            else if (take('"'))
                value += '"';
            else
                return value;
        }
    }

    std::string_view text_;
    const std::filesystem::path& file_;
    std::size_t at_ = 0;
    int line_ = 1;
};

std::string field_text(const std::string& value) {
    if (value.find_first_of(",\"\r\n") == std::string::npos) return value;
    std::string quoted = "\"";
    for (const char c : value) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

void append_record(const std::vector<std::string>& fields, std::string& text) {
    for (std::size_t k = 0; k < fields.size(); ++k) text += (k == 0 ? "" : ",") + field_text(fields[k]);
    text += '\n';
}

}  // namespace

std::optional<std::size_t> TextTable::find(std::string_view name) const {
    for (std::size_t k = 0; k < heading.size(); ++k)
        if (heading[k] == name) return k;
    for (std::size_t k = 0; k < heading.size(); ++k)
        if (heading[k].starts_with(std::string(name) + " (")) return k;
    return std::nullopt;
}

TextTable read_csv(const std::filesystem::path& file) {
    const std::string text = read_text_file(file);
    CsvReader reader(text, file);
    if (reader.at_end()) reader.fail("is empty", "a line of headings");
    TextTable table;
    table.heading = reader.record();
    while (!reader.at_end()) {
        std::vector<std::string> record = reader.record();
        if (record.size() != table.heading.size())
            throw InputError({file.string(), reader.line() - 1},
                             "has " + std::to_string(record.size()) + " fields",
                             std::to_string(table.heading.size()) + ", as in the first line");
        table.rows.push_back(std::move(record));
    }
    return table;
}

std::string number_field(const std::optional<double>& value) {
    return value ? shortest_text(*value) : "";
}

std::string csv_text(const TextTable& table) {
    std::string text;
    append_record(table.heading, text);
    for (const auto& row : table.rows) append_record(row, text);
    return text;
}

}  // namespace rockslope::study
