#include <algorithm>

#include "common/base/text.hpp"
#include "common/config/config_view.hpp"
#include "common/config/toml_text.hpp"

namespace rockslope {

namespace {

std::string joined(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
}

std::string number_text(double value) {
    std::string text = shortest_text(value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

using NameOfFile = std::function<std::string(const std::filesystem::path&)>;

struct TextStyle {
    NameOfFile name_of_file;
    bool marks_defaults = true;
};

void append_values(const ConfigTable::Impl& view, const TextStyle& style, std::string& text) {
    for (const auto& entry : view.entries) {
        if (!entry.tables.empty()) continue;
        text += key_text(entry.key) + " = " +
                (entry.file.empty() ? entry.value : toml_string(style.name_of_file(entry.file))) +
                (entry.is_default && style.marks_defaults ? "  # default\n" : "\n");
    }
}

/// Whether a table has no values of its own. It then needs no heading, because its sub-tables imply it.
bool holds_only_tables(const ConfigTable::Impl& view) {
    return !view.entries.empty() && std::all_of(view.entries.begin(), view.entries.end(),
                                                [](const auto& entry) { return !entry.tables.empty(); });
}

void append_table(const ConfigTable::Impl& view, const std::string& path, const TextStyle& style,
                  std::string& text) {
    append_values(view, style, text);
    for (const auto& entry : view.entries) {
        const std::string below = joined(path, key_text(entry.key));
        for (const auto& table : entry.tables) {
            if (!entry.is_array && holds_only_tables(*table)) {
                append_table(*table, below, style, text);
                continue;
            }
            text += entry.is_array ? "\n[[" + below + "]]\n" : "\n[" + below + "]\n";
            append_table(*table, below, style, text);
        }
    }
}

}  // namespace

std::string toml_string(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            (result += '\\') += c;
        } else if (code < 0x20 || code == 0x7f) {
            constexpr char digits[] = "0123456789abcdef";
            ((result += "\\u00") += digits[code >> 4]) += digits[code & 15];
        } else {
            result += c;
        }
    }
    return result += '"';
}

std::string key_text(std::string_view key) {
    const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    });
    return bare ? std::string(key) : toml_string(key);
}

std::string inline_text(const toml::node& node) {
    if (const auto* value = node.as_string()) return toml_string(value->get());
    if (const auto* value = node.as_integer()) return std::to_string(value->get());
    if (const auto* value = node.as_floating_point()) return number_text(value->get());
    if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
    std::string text;
    if (const auto* array = node.as_array()) {
        for (const toml::node& element : *array) text += (text.empty() ? "" : ", ") + inline_text(element);
        return "[" + text + "]";
    }
    if (const auto* table = node.as_table()) {
        for (const auto& [key, value] : *table)
            text += (text.empty() ? "" : ", ") + key_text(key.str()) + " = " + inline_text(value);
        return "{" + text + "}";
    }
    return "\"\"";
}

std::string ConfigTable::effective_text(const std::filesystem::path& folder) const {
    const auto name_of_file = [&](const std::filesystem::path& file) {
        return folder.empty()
                   ? file.string()
                   : file.lexically_relative(std::filesystem::absolute(folder).lexically_normal()).string();
    };
    std::string text;
    append_table(*impl_, {}, {name_of_file}, text);
    return text;
}

std::string ConfigTable::effective_text(const NameOfFile& name_of_file) const {
    std::string text;
    append_table(*impl_, {}, {name_of_file, false}, text);
    return text;
}

}  // namespace rockslope
