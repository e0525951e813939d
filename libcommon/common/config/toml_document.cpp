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

toml::table parse_toml(std::string_view text, const std::string& file_name) {
    try {
        return toml::parse(text, std::string_view(file_name));
    } catch (const toml::parse_error& error) {
        const auto& where = error.source().begin;
        throw InputError({file_name, static_cast<int>(where.line), static_cast<int>(where.column)},
                         std::string(error.description()), "a TOML file");
    }
}

void apply_override(toml::table& root, const std::string& assignment) {
    const SourceLocation place{std::string(override_mark) + assignment};
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) throw InputError(place, "there is no '='", "key=value");
    const std::vector<PathStep> steps =
        OverridePath(std::string_view(assignment).substr(0, equals), place).steps();
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
