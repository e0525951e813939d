#include "common/config/config_table.hpp"

#include <algorithm>
#include <cmath>

#include "common/base/magnitude.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "common/config/config_view.hpp"
#include "common/config/toml_text.hpp"
#include "common/config/units.hpp"

namespace rockslope {

namespace {

/// A TOML value to be converted, with its location and its name in messages.
struct Value {
    const toml::node& node;
    SourceLocation place;
    std::string label;

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw InputError(place, label + " is " + found, expected);
    }
    Value element(std::size_t index) const {
        const toml::node& child = *node.as_array()->get(index);
        return {child, location_of(child, place), label + " (entry " + std::to_string(index + 1) + ")"};
    }
    std::size_t array_size(const std::string& expected) const {
        if (!node.is_array()) fail(std::string(type_name(node)), expected);
        return node.as_array()->size();
    }
};

double quantity_of_text(const Value& value, Dimension dimension, const std::string& text) {
    const std::size_t end = text.find_first_not_of("+-.0123456789eE");
    const std::size_t digits = end == std::string::npos ? text.size() : end;
    const std::optional<double> number = parse_number(std::string_view(text).substr(0, digits));
    const std::size_t unit_start = std::min(text.find_first_not_of(' ', digits), text.size());
    const std::string unit = text.substr(unit_start);
    const std::string shown = "\"" + text + "\"";
    if (!number || dimension == Dimension::none) value.fail("the string " + shown, describe(dimension));
    if (unit.empty()) value.fail(shown + ", which has no unit", describe(dimension));
    const std::optional<double> factor = unit_factor(dimension, unit);
    if (!factor) value.fail(shown + ", whose unit does not fit", describe(dimension));
    const double converted = *number * *factor;
    if (!is_in_allowed_range(converted)) value.fail(shown + ", which is too large", describe(dimension));
    return converted;
}

double quantity(const Value& value, Dimension dimension) {
    if (const auto* text = value.node.as_string()) return quantity_of_text(value, dimension, text->get());
    const bool is_number = value.node.is_integer() || value.node.is_floating_point();
    if (!is_number) value.fail(std::string(type_name(value.node)), describe(dimension));
    const double number = value.node.value<double>().value_or(std::nan(""));
    if (!std::isfinite(number))
        value.fail(inline_text(value.node) + ", which is not a finite number", describe(dimension));
    if (!is_in_allowed_range(number))
        value.fail(shortest_text(number) + ", which is too large", describe(dimension));
    if (dimension == Dimension::angle && number != 0)
        value.fail(shortest_text(number) + ", without a unit", describe(dimension));
    return number;
}

std::array<double, 2> quantity_pair(const Value& value, Dimension dimension) {
    const std::string expected = "two numbers, [x, y]";
    if (value.array_size(expected) != 2)
        value.fail("an array of " + std::to_string(value.array_size(expected)), expected);
    return {quantity(value.element(0), dimension), quantity(value.element(1), dimension)};
}

std::vector<std::array<double, 2>> quantity_pairs(const Value& value, Dimension dimension) {
    std::vector<std::array<double, 2>> result;
    const std::size_t count = value.array_size("a list of points, [[x, y], ...]");
    for (std::size_t i = 0; i < count; ++i) result.push_back(quantity_pair(value.element(i), dimension));
    return result;
}

std::string string_of(const Value& value) {
    const auto* text = value.node.as_string();
    if (!text) value.fail(std::string(type_name(value.node)), "a string");
    return text->get();
}

std::string default_quantity_text(double value, Dimension dimension) {
    if (dimension == Dimension::angle && value != 0) return toml_string(shortest_text(value) + " rad");
    return inline_text(toml::value<double>(value));
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

/// The node of a key that holds tables, or of any key whose type is not yet checked.
Value node_of(ConfigTable::Impl& view, std::string_view key, const std::string& expected) {
    const toml::node& node = view.require(key, expected);
    return {node, location_of(node, view.place), view.label(key)};
}

/// The node of a key that holds a value, which is recorded for effective_text.
Value value_of(ConfigTable::Impl& view, std::string_view key, const std::string& expected) {
    Value value = node_of(view, key, expected);
    view.record({std::string(key), inline_text(value.node), {}, false, false, {}});
    return value;
}

}  // namespace

ConfigTable ConfigTable::from_file(const std::filesystem::path& path,
                                   const std::vector<std::string>& overrides) {
    ConfigTable table = from_text(read_text_file(path), path.string(), overrides);
    table.impl_->folder = std::filesystem::absolute(path).parent_path();
    return table;
}

ConfigTable ConfigTable::from_text(std::string_view text, const std::string& file_name,
                                   const std::vector<std::string>& overrides) {
    toml::table root = parse_toml(text, file_name);
    for (const std::string& assignment : overrides) apply_override(root, assignment);
    auto impl = std::make_shared<Impl>();
    impl->root = std::make_shared<const toml::table>(std::move(root));
    impl->table = impl->root.get();
    impl->place = {file_name};
    impl->folder = std::filesystem::current_path();
    return ConfigTable(std::move(impl));
}

bool ConfigTable::has(std::string_view key) const {
    return impl_->find(key) != nullptr;
}

SourceLocation ConfigTable::place(std::string_view key) const {
    const toml::node* node = key.empty() ? nullptr : impl_->table->get(key);
    return node ? location_of(*node, impl_->place) : impl_->place;
}

const std::string& ConfigTable::path() const {
    return impl_->path;
}

double ConfigTable::number(std::string_view key, Dimension dimension) const {
    return quantity(value_of(*impl_, key, describe(dimension)), dimension);
}

double ConfigTable::number(std::string_view key, Dimension dimension, double fallback) const {
    if (has(key)) return number(key, dimension);
    impl_->record_default(key, default_quantity_text(fallback, dimension));
    return fallback;
}

std::int64_t ConfigTable::integer(std::string_view key) const {
    const Value value = value_of(*impl_, key, "a whole number");
    const auto* number = value.node.as_integer();
    if (!number) value.fail(std::string(type_name(value.node)), "a whole number");
    return number->get();
}

std::int64_t ConfigTable::integer(std::string_view key, std::int64_t fallback) const {
    if (has(key)) return integer(key);
    impl_->record_default(key, std::to_string(fallback));
    return fallback;
}

bool ConfigTable::boolean(std::string_view key, bool fallback) const {
    if (!has(key)) {
        impl_->record_default(key, fallback ? "true" : "false");
        return fallback;
    }
    const Value value = value_of(*impl_, key, "true or false");
    const auto* flag = value.node.as_boolean();
    if (!flag) value.fail(std::string(type_name(value.node)), "true or false");
    return flag->get();
}

std::string ConfigTable::string(std::string_view key) const {
    return string_of(value_of(*impl_, key, "a string"));
}

std::string ConfigTable::string(std::string_view key, std::string_view fallback) const {
    if (has(key)) return string(key);
    impl_->record_default(key, toml_string(fallback));
    return std::string(fallback);
}

std::string ConfigTable::choice(std::string_view key, const std::vector<std::string>& choices) const {
    const Value value = value_of(*impl_, key, "one of " + listed(choices));
    std::string word = string_of(value);
    if (std::find(choices.begin(), choices.end(), word) != choices.end()) return word;
    const std::optional<std::string> nearest = nearest_word(word, choices);
    value.fail("\"" + word + "\"" + (nearest ? "; did you mean \"" + *nearest + "\"?" : std::string()),
               "one of " + listed(choices));
}

std::string ConfigTable::choice(std::string_view key, const std::vector<std::string>& choices,
                                std::string_view fallback) const {
    if (has(key)) return choice(key, choices);
    impl_->record_default(key, toml_string(fallback));
    return std::string(fallback);
}

std::array<double, 2> ConfigTable::pair(std::string_view key, Dimension dimension) const {
    return quantity_pair(value_of(*impl_, key, "two numbers, [x, y]"), dimension);
}

std::array<double, 2> ConfigTable::pair(std::string_view key, Dimension dimension,
                                        std::array<double, 2> fallback) const {
    if (has(key)) return pair(key, dimension);
    impl_->record_default(key, "[" + default_quantity_text(fallback[0], dimension) + ", " +
                                   default_quantity_text(fallback[1], dimension) + "]");
    return fallback;
}

std::vector<std::array<double, 2>> ConfigTable::pairs(std::string_view key, Dimension dimension) const {
    return quantity_pairs(value_of(*impl_, key, "a list of points, [[x, y], ...]"), dimension);
}

std::vector<double> ConfigTable::numbers(std::string_view key, Dimension dimension) const {
    const Value value = value_of(*impl_, key, "a list of numbers");
    std::vector<double> result;
    const std::size_t count = value.array_size("a list of numbers");
    for (std::size_t i = 0; i < count; ++i) result.push_back(quantity(value.element(i), dimension));
    return result;
}

std::vector<std::string> ConfigTable::strings(std::string_view key) const {
    const Value value = value_of(*impl_, key, "a list of strings");
    std::vector<std::string> result;
    const std::size_t count = value.array_size("a list of strings");
    for (std::size_t i = 0; i < count; ++i) result.push_back(string_of(value.element(i)));
    return result;
}

std::vector<std::string> ConfigTable::value_texts(std::string_view key) const {
    std::vector<std::string> result;
    const Value value = value_of(*impl_, key, "a list of values");
    const std::size_t count = value.array_size("a list of values");
    for (std::size_t i = 0; i < count; ++i) result.push_back(inline_text(value.element(i).node));
    return result;
}

std::vector<std::vector<std::array<double, 2>>> ConfigTable::rings(std::string_view key) const {
    std::vector<std::vector<std::array<double, 2>>> result;
    if (!has(key)) return result;
    const std::string expected = "a list of rings, [[[x, y], ...], ...]";
    const Value value = value_of(*impl_, key, expected);
    const std::size_t count = value.array_size(expected);
    for (std::size_t i = 0; i < count; ++i)
        result.push_back(quantity_pairs(value.element(i), Dimension::length));
    return result;
}

bool ConfigTable::is_table(std::string_view key) const {
    const toml::node* node = impl_->find(key);
    return node && node->is_table();
}

bool ConfigTable::is_string(std::string_view key) const {
    const toml::node* node = impl_->find(key);
    return node && node->is_string();
}

ConfigTable ConfigTable::table(std::string_view key) const {
    const Value value = node_of(*impl_, key, "a table [" + std::string(key) + "]");
    const toml::table* node = value.node.as_table();
    if (!node) value.fail(std::string(type_name(value.node)), "a table");
    return ConfigTable(impl_->table_entry(key, *node));
}

ConfigTable ConfigTable::table_or_empty(std::string_view key) const {
    static const toml::table empty;
    return has(key) ? table(key) : ConfigTable(impl_->table_entry(key, empty));
}

std::optional<ConfigTable> ConfigTable::optional_table(std::string_view key) const {
    if (!has(key)) return std::nullopt;
    return table(key);
}

std::vector<ConfigTable> ConfigTable::array_of_tables(std::string_view key) const {
    std::vector<ConfigTable> result;
    if (!has(key)) return result;
    const std::string expected = "an array of tables, [[" + std::string(key) + "]]";
    const Value value = node_of(*impl_, key, expected);
    const std::size_t count = value.array_size(expected);
    const auto same = [&](const Impl::Entry& entry) { return entry.key == key; };
    if (std::none_of(impl_->entries.begin(), impl_->entries.end(), same)) {
        Impl::Entry entry{std::string(key), "[]", {}, false, true, {}};
        for (std::size_t i = 0; i < count; ++i) {
            const Value element = value.element(i);
            const toml::table* node = element.node.as_table();
            if (!node) element.fail(std::string(type_name(element.node)), "a table");
            entry.tables.push_back(impl_->child(*node, key_text(key) + "[" + std::to_string(i) + "]"));
        }
        impl_->record(std::move(entry));
    }
    const auto entry = std::find_if(impl_->entries.begin(), impl_->entries.end(), same);
    for (const auto& table : entry->tables) result.push_back(ConfigTable(table));
    return result;
}

std::vector<std::pair<std::string, ConfigTable>> ConfigTable::named_tables() const {
    std::vector<std::pair<std::string, ConfigTable>> result;
    for (const std::string& key : impl_->unread_keys()) result.emplace_back(key, table(key));
    return result;
}

std::filesystem::path ConfigTable::file_path(std::string_view key) const {
    const Value value = value_of(*impl_, key, "the path of a file");
    const std::string text = string_of(value);
    if (text.empty()) value.fail("empty", "the path of a file");
    const bool from_override = value.place.line == 0;
    const auto folder = from_override ? std::filesystem::current_path() : impl_->folder;
    std::filesystem::path file = (folder / text).lexically_normal();
    const auto same = [&](const Impl::Entry& entry) { return entry.key == key; };
    std::find_if(impl_->entries.begin(), impl_->entries.end(), same)->file = file;
    return file;
}

double ConfigTable::checked(std::string_view key, double value, const std::function<bool(double)>& accepted,
                            const std::string& expected) const {
    if (!accepted(value)) fail(key, impl_->label(key) + " is " + shortest_text(value), expected);
    return value;
}

void ConfigTable::fail(std::string_view key, const std::string& what, const std::string& expected) const {
    throw InputError(place(key), what, expected);
}

void ConfigTable::finish() const {
    for (const std::string& key : impl_->unread_keys()) {
        const std::optional<std::string> nearest = nearest_word(key, impl_->known);
        const std::string what = "unknown key " + impl_->label(key);
        if (nearest) throw InputError(place(key), what + "; did you mean '" + *nearest + "'?", {});
        throw InputError(place(key), what,
                         impl_->known.empty() ? "no key here" : "one of " + listed(impl_->known));
    }
    for (const Impl::Entry& entry : impl_->entries)
        for (const auto& table : entry.tables) ConfigTable(table).finish();
}

}  // namespace rockslope
