#include "support/report_row.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace rockslope::verification {

namespace {

constexpr std::array<std::string_view, 12> columns = {"id",       "set_up", "quantity", "unit",
                                                      "expected", "ours",   "error",    "tolerance",
                                                      "kind",     "w_dt",   "verdict",  "reason"};
constexpr std::array<std::string_view, 6> kinds = {"relative", "absolute", "below",
                                                   "above",    "outcome",  "none"};
constexpr std::array<std::string_view, 4> verdicts = {"passes", "fails", "misses", "informs"};

template <std::size_t n>
std::size_t index_of(const std::array<std::string_view, n>& words, std::string_view word) {
    for (std::size_t k = 0; k < n; ++k) {
        if (words[k] == word) return k;
    }
    throw std::runtime_error("unknown word '" + std::string(word) + "'");
}

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::size_t begin = 0;
    for (std::size_t end; (end = line.find('\t', begin)) != std::string::npos; begin = end + 1) {
        fields.push_back(line.substr(begin, end - begin));
    }
    fields.push_back(line.substr(begin));
    return fields;
}

Row row_of(const std::vector<std::string>& f) {
    if (f.size() != columns.size()) throw std::runtime_error(std::to_string(f.size()) + " fields");
    return {f[0],
            f[1],
            f[2],
            f[3],
            f[4],
            f[5],
            f[6],
            f[7],
            static_cast<ToleranceKind>(index_of(kinds, f[8])),
            f[9],
            static_cast<Verdict>(index_of(verdicts, f[10])),
            f[11]};
}

std::string header() {
    std::ostringstream out;
    write_header(out);
    std::string line = out.str();
    line.pop_back();
    return line;
}

}  // namespace

std::string to_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string to_text(ToleranceKind kind) {
    return std::string(kinds.at(static_cast<std::size_t>(kind)));
}

std::string to_text(Verdict verdict) {
    return std::string(verdicts.at(static_cast<std::size_t>(verdict)));
}

void write_header(std::ostream& out) {
    for (std::size_t k = 0; k < columns.size(); ++k) out << (k > 0 ? "\t" : "") << columns[k];
    out << '\n';
}

void write_row(std::ostream& out, const Row& row) {
    out << row.id << '\t' << row.set_up << '\t' << row.quantity << '\t' << row.unit << '\t' << row.expected
        << '\t' << row.ours << '\t' << row.error << '\t' << row.tolerance << '\t' << to_text(row.kind) << '\t'
        << row.contact_frequency_step << '\t' << to_text(row.verdict) << '\t' << row.reason << '\n';
}

std::vector<Row> read_rows(const std::string& path) {
    std::ifstream in(path);
    if (!in) throw std::runtime_error(path + ": cannot be read");
    std::string line;
    if (!std::getline(in, line) || line != header())
        throw std::runtime_error(path + ":1: not the header of report rows");
    std::vector<Row> rows;
    for (int number = 2; std::getline(in, line); ++number) {
        try {
            rows.push_back(row_of(fields_of(line)));
        } catch (const std::exception& error) {
            throw std::runtime_error(path + ":" + std::to_string(number) + ": " + error.what());
        }
    }
    return rows;
}

}  // namespace rockslope::verification
