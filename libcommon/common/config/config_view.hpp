#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include "common/config/config_table.hpp"

namespace rockslope {

/// Where a node stands; `fallback` when it was made, not parsed. Overrides have a file ("--set key=value")
/// and no line.
SourceLocation location_of(const toml::node& node, const SourceLocation& fallback);

/// The type of a node in a user's words: "a string", "a table", ...
std::string_view type_name(const toml::node& node);

/// A node as one line of TOML; floats shortest-round-trip.
std::string inline_text(const toml::node& node);

/// A TOML string literal of `text`, and a key, quoted where TOML asks for it.
std::string toml_string(std::string_view text);
std::string key_text(std::string_view key);

/// Parses a document; the names in error places are `file_name`.
toml::table parse_toml(std::string_view text, const std::string& file_name);

/// Sets one value, "key.path[index].key=value".
void apply_override(toml::table& root, const std::string& assignment);

/// What has been read of one table.
struct ConfigTable::Impl {
    /// A key that was read: its value as TOML text, or the tables below it.
    struct Entry {
        std::string key;
        std::string value;
        std::filesystem::path file;  ///< of a key that names a file, in place of `value`
        bool is_default = false;
        bool is_array = false;
        std::vector<std::shared_ptr<Impl>> tables;
    };

    std::shared_ptr<const toml::table> root;  ///< keeps the nodes alive
    const toml::table* table = nullptr;
    SourceLocation place;
    std::filesystem::path folder;  ///< of the model file
    std::string path;
    std::vector<std::string> known;  ///< keys that somebody asked for
    std::vector<Entry> entries;      ///< in the order of first reading

    /// Marks the key as known; its node, or null.
    const toml::node* find(std::string_view key);
    void record(Entry entry);
    void record_default(std::string_view key, const std::string& value) {
        record({std::string(key), value, {}, true, false, {}});
    }
    /// The key's node; an error when there is none, naming the misspelt key that stands in its place if there
    /// is one.
    const toml::node& require(std::string_view key, const std::string& expected);
    std::string label(std::string_view key) const;
    std::shared_ptr<Impl> child(const toml::table& node, const std::string& child_path) const;
    /// The view of the table under a key: the same one each time.
    std::shared_ptr<Impl> table_entry(std::string_view key, const toml::table& node);
    std::vector<std::string> unread_keys() const;
};

}  // namespace rockslope
