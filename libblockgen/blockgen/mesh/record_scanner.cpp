#include "blockgen/mesh/record_scanner.hpp"

#include <charconv>
#include <cmath>
#include <utility>

#include "blockgen/mesh/names.hpp"
#include "common/base/magnitude.hpp"

namespace rockslope::blockgen {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

RecordScanner::RecordScanner(std::string_view text, std::string file_name)
    : text_(text), file_name_(std::move(file_name)) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

bool RecordScanner::next_line() {
    while (next_start_ < text_.size()) {
        ++line_;
        line_start_ = position_ = word_start_ = next_start_;
        const std::size_t newline = text_.find('\n', line_start_);
        line_end_ = newline == std::string_view::npos ? text_.size() : newline;
        next_start_ = newline == std::string_view::npos ? text_.size() : newline + 1;
        if (!at_line_end()) return true;
    }
    line_start_ = position_ = word_start_ = line_end_ = text_.size();
    return false;
}

void RecordScanner::skip_blanks() {
    while (position_ < line_end_ && is_blank(text_[position_])) ++position_;
}

bool RecordScanner::at_line_end() {
    skip_blanks();
    return position_ == line_end_ || text_[position_] == '#';
}

std::string_view RecordScanner::word(std::string_view expected) {
    const bool none = at_line_end();
    word_start_ = position_;
    if (none) fail("the line ends early", std::string(expected));
    while (position_ < line_end_ && !is_blank(text_[position_]) && text_[position_] != '#') ++position_;
    return text_.substr(word_start_, position_ - word_start_);
}

char RecordScanner::escaped_character() {
    const char c = position_ < line_end_ ? text_[position_++] : '\0';
    switch (c) {
        case '"':
        case '\\':
            return c;
        case 'n':
            return '\n';
        case 'r':
            return '\r';
        case 't':
            return '\t';
        default:
            break;
    }
    if (c == 'x' && position_ + 2 <= line_end_) {
        const int high = hex_digit(text_[position_]);
        const int low = hex_digit(text_[position_ + 1]);
        position_ += 2;
        if (high >= 0 && low >= 0) return static_cast<char>(high * 16 + low);
    }
    fail("unknown escape in a quoted name", "\\\", \\\\, \\n, \\r, \\t or \\xHH");
}

std::string RecordScanner::name(std::string_view expected) {
    std::string result;
    if (at_line_end() || text_[position_] != '"') {
        result = std::string(word(expected));
    } else {
        word_start_ = position_++;
        while (position_ < line_end_ && text_[position_] != '"') {
            const char c = text_[position_++];
            result += c == '\\' ? escaped_character() : c;
        }
        if (position_ == line_end_) fail("a quoted name is not closed", "a \" on the same line");
        ++position_;
    }
    if (!is_utf8(result)) fail("a name is not UTF-8", std::string(expected));
    return result;
}

double RecordScanner::number(std::string_view expected) {
    const std::string_view digits = word(expected);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
        fail("'" + std::string(digits) + "' is not a finite number", std::string(expected));
    if (!is_in_allowed_range(value))
        fail("'" + std::string(digits) + "' is too large", std::string(expected));
    return value;
}

std::int32_t RecordScanner::index(std::string_view expected, std::int64_t limit) {
    const std::string_view digits = word(expected);
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range)
        fail("'" + std::string(digits) + "' is too large", std::string(expected));
    if (error != std::errc() || end != digits.data() + digits.size())
        fail("'" + std::string(digits) + "' is not an integer", std::string(expected));
    if (value < 0 || value >= limit)
        fail("index " + std::to_string(value) + " is out of range",
             limit > 0 ? std::string(expected) + " from 0 to " + std::to_string(limit - 1)
                       : "none: the counts line announces no " + std::string(expected));
    return value;
}

void RecordScanner::expect_line_end() {
    if (at_line_end()) return;
    const std::string extra(word("the end of the line"));
    fail("'" + extra + "' is one word too many", "the end of the line");
}

SourceLocation RecordScanner::place() const {
    return {file_name_, line_, static_cast<int>(word_start_ - line_start_) + 1};
}

void RecordScanner::fail(const std::string& what, const std::string& expected) const {
    throw InputError(place(), what, expected);
}

}  // namespace rockslope::blockgen
