#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

#include "common/base/text.hpp"
#include "common/config/config_view.hpp"
#include "common/config/toml_text.hpp"

namespace rockslope {

namespace {

constexpr std::string_view override_mark = "--set ";

/// One step of an override's path: a key, or an index into an array of tables.
struct PathStep {
    std::string key;
    std::optional<std::size_t> index;
};

class OverridePath {
  public:
    OverridePath(std::string_view text, const SourceLocation& place) : rest_(text), place_(place) {}

    std::vector<PathStep> steps() {
        std::vector<PathStep> result;
        do {
            result.push_back({key(), std::nullopt});
            while (take('[')) result.push_back({{}, index()});
        } while (take('.'));
        if (!rest_.empty()) fail();
        return result;
    }

  private:
    [[noreturn]] void fail() const {
        throw InputError(place_, "the key is not a path of names and indices",
                         "for example --set stage[1].step=0.005");
    }
    bool take(char c) {
        if (rest_.empty() || rest_.front() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    std::string key() {
        const bool in_quotes = take('"');
        const std::size_t end = std::min(rest_.find_first_of(in_quotes ? "\"" : ".["), rest_.size());
        std::string result(rest_.substr(0, end));
        rest_.remove_prefix(end);
        if (result.empty() || (in_quotes && !take('"'))) fail();
        return result;
    }
    std::size_t index() {
        std::size_t value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc{}) fail();
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        if (!take(']')) fail();
        return value;
    }

    std::string_view rest_;
    const SourceLocation& place_;
};

bool starts_like_toml(std::string_view value) {
    return !value.empty() && std::string_view("\"'[{").find(value.front()) != std::string_view::npos;
}

/// The value of an override as a table {v = value}. The source location of its node is the override.
toml::table override_value(std::string_view value, const std::string& source) {
    try {
        toml::table parsed = toml::parse("v = " + std::string(value), std::string_view(source));
        if (parsed.size() == 1 && parsed.contains("v")) return parsed;
    } catch (const toml::parse_error& error) {
        if (starts_like_toml(value))
            throw InputError({source}, std::string(error.description()), "a value in TOML syntax");
    }
    return toml::parse("v = " + toml_string(value), std::string_view(source));
}

/// The names in a row, joined by points, that a key may have: toml++ and what reads its tables call
/// themselves for each table in a table.
constexpr int most_names = 64;

/// Walks over a TOML text outside strings and comments.
class KeyScanner {
  public:
    explicit KeyScanner(std::string_view text) : text_(text) {}

    /// The line, from 1, of the first key with more than most_names names; 0 when there is none.
    int line_of_longest_key() {
        int names = 0;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"' || c == '\'') {
                skip_string(c);
                continue;
            }
            if (c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
                continue;
            }
            if (c == '.' && ++names >= most_names) return line_;
            const bool in_key = c == '.' || c == '_' || c == '-' || c == ' ' || c == '\t' ||
                                std::isalnum(static_cast<unsigned char>(c)) != 0;
            if (!in_key) names = 0;
            line_ += c == '\n' ? 1 : 0;
            ++at_;
        }
        return 0;
    }

  private:
    void skip_string(char quote) {
        const bool is_long = text_.substr(at_, 3) == std::string(3, quote);
        const std::size_t width = is_long ? 3 : 1;
        for (at_ += width; at_ < text_.size(); ++at_) {
            if (text_[at_] == '\n' && !is_long) return;  // no string: the parser says so
            if (text_[at_] == '\n') ++line_;
            if (text_[at_] == '\\' && quote == '"') {
                if (at_ + 1 < text_.size() && text_[at_ + 1] == '\n') continue;
                ++at_;
            } else if (text_.substr(at_, width) == std::string(width, quote)) {
                at_ += width;
                return;
            }
        }
        at_ = std::min(at_, text_.size());
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

[[noreturn]] void reject_step(const SourceLocation& place, const std::string& parent,
                              const std::string& found, const std::string& expected) {
    throw InputError(place, "'" + parent + "' is " + found, expected);
}

}  // namespace

SourceLocation location_of(const toml::node& node, const SourceLocation& fallback) {
    const toml::source_region& source = node.source();
    if (!source.path) return fallback;
    if (source.path->starts_with(override_mark)) return {*source.path};
    return {*source.path, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

std::string_view type_name(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "a whole number";
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        default:
            return "a date or time";
    }
}

namespace {

/// What a text that does not parse should have been. At a blank in a name toml++ expects the name's end.
std::string expected_of(std::string_view description) {
    const auto says = [&](std::string_view words) {
        return description.find(words) != std::string_view::npos;
    };
    const bool name_ends_early =
        (says("expected ']', saw") || says("expected '=', saw")) && !says("saw '\\n'");
    return name_ends_early
               ? "a TOML file; a name with blanks or other signs needs quotes, as in [table.\"two words\"]"
               : "a TOML file";
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file_name) {
    if (const int line = KeyScanner(text).line_of_longest_key(); line > 0)
        throw InputError({file_name, line}, "a key has more than " + std::to_string(most_names) + " names",
                         "tables that are not as deep");
    try {
        return toml::parse(text, std::string_view(file_name));
    } catch (const toml::parse_error& error) {
        const auto& where = error.source().begin;
        throw InputError({file_name, static_cast<int>(where.line), static_cast<int>(where.column)},
                         std::string(error.description()), expected_of(error.description()));
    }
}

void apply_override(toml::table& root, const std::string& assignment) {
    const SourceLocation place{std::string(override_mark) + assignment};
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) throw InputError(place, "there is no '='", "key=value");
    const std::vector<PathStep> steps =
        OverridePath(std::string_view(assignment).substr(0, equals), place).steps();
    if (steps.size() > most_names)
        throw InputError(place, "the key has more than " + std::to_string(most_names) + " names",
                         "a shorter key");
    toml::table value = override_value(std::string_view(assignment).substr(equals + 1), place.file);

    toml::node* node = &root;
    std::string parent;  // path of the steps before
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const PathStep& step = steps[i];
        const bool last = i + 1 == steps.size();
        if (step.index) {
            toml::array* array = node->as_array();
            if (!array) reject_step(place, parent, std::string(type_name(*node)), "an array before an index");
            if (*step.index >= array->size())
                reject_step(place, parent, "an array of " + std::to_string(array->size()),
                            "an index below that, counted from 0");
            if (last)
                array->replace(array->cbegin() + static_cast<std::ptrdiff_t>(*step.index),
                               std::move(*value.get("v")));
            else
                node = array->get(*step.index);
            parent += '[' + std::to_string(*step.index) + ']';
            continue;
        }
        toml::table* table = node->as_table();
        if (!table) reject_step(place, parent, std::string(type_name(*node)), "a table before a key");
        if (last)
            table->insert_or_assign(step.key, std::move(*value.get("v")));
        else if (!table->contains(step.key))
            table->insert(step.key, toml::table{});
        node = table->get(step.key);
        parent += (parent.empty() ? "" : ".") + step.key;
    }
}

}  // namespace rockslope
