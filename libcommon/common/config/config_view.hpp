#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include "common/config/config_table.hpp"

namespace rockslope {

/// Location of a node, or `fallback` if it was not parsed. The location of an override is the file
/// "--set key=value" without a line.
SourceLocation location_of(const toml::node& node, const SourceLocation& fallback);

/// The type of a node for messages: "a string", "a table", ...
std::string_view type_name(const toml::node& node);

/// A node as one line of TOML. Floats are the shortest text that reads back to the same double.
std::string inline_text(const toml::node& node);

/// A TOML key, quoted where TOML requires it.
std::string key_text(std::string_view key);

/// Parses a document. @param file_name for the locations of errors.
toml::table parse_toml(std::string_view text, const std::string& file_name);

/// Sets one value, "key.path[index].key=value".
void apply_override(toml::table& root, const std::string& assignment);

/// One table and the record of what has been read from it.
struct ConfigTable::Impl {
    /// A key that was read: its value as TOML text, or the tables below it.
    struct Entry {
        std::string key;
        std::string value;
        std::filesystem::path file;  ///< used instead of `value` if the key names a file
        bool is_default = false;
        bool is_array = false;
        std::vector<std::shared_ptr<Impl>> tables;
    };

    std::shared_ptr<const toml::table> root;  ///< keeps the nodes alive
    const toml::table* table = nullptr;
    SourceLocation place;
    std::filesystem::path folder;  ///< of the model file
    std::string path;
    std::vector<std::string> known;  ///< keys asked for, present or not
    std::vector<Entry> entries;      ///< in the order of first reading

    /// Marks the key as known. @return its node, or null.
    const toml::node* find(std::string_view key);
    void record(Entry entry);
    void record_default(std::string_view key, const std::string& value) {
        record({std::string(key), value, {}, true, false, {}});
    }
    /// The node of a key. @throws InputError when it is absent; names an unread key that looks like a
    /// misspelling of it.
    const toml::node& require(std::string_view key, const std::string& expected);
    std::string label(std::string_view key) const;
    std::shared_ptr<Impl> child(const toml::table& node, const std::string& child_path) const;
    /// The view of the table under a key, the same one at each call.
    std::shared_ptr<Impl> table_entry(std::string_view key, const toml::table& node);
    std::vector<std::string> unread_keys() const;
};

}  // namespace rockslope
