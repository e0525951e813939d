#include "common/config/config_view.hpp"

#include <algorithm>

#include "common/base/text.hpp"

namespace rockslope {

const toml::node* ConfigTable::Impl::find(std::string_view key) {
    if (std::find(known.begin(), known.end(), key) == known.end()) known.emplace_back(key);
    return table->get(key);
}

void ConfigTable::Impl::record(Entry entry) {
    const auto same = [&](const Entry& other) { return other.key == entry.key; };
    if (std::none_of(entries.begin(), entries.end(), same)) entries.push_back(std::move(entry));
}

std::string ConfigTable::Impl::label(std::string_view key) const {
    const std::string name = "'" + std::string(key) + "'";
    return path.empty() ? name : name + " in [" + path + "]";
}

const toml::node& ConfigTable::Impl::require(std::string_view key, const std::string& expected) {
    if (const toml::node* node = find(key)) return *node;
    const std::vector<std::string> unread = unread_keys();
    const std::string wanted[] = {std::string(key)};
    for (const std::string& candidate : unread)
        if (nearest_word(candidate, wanted))
            throw InputError(location_of(*table->get(candidate), place),
                             "unknown key " + label(candidate) + "; did you mean '" + std::string(key) + "'?",
                             {});
    throw InputError(place, "there is no key " + label(key), expected);
}

std::shared_ptr<ConfigTable::Impl> ConfigTable::Impl::child(const toml::table& node,
                                                            const std::string& child_path) const {
    auto result = std::make_shared<Impl>();
    result->root = root;
    result->table = &node;
    result->place = location_of(node, place);
    result->folder = folder;
    result->path = path.empty() ? child_path : path + "." + child_path;
    return result;
}

std::shared_ptr<ConfigTable::Impl> ConfigTable::Impl::table_entry(std::string_view key,
                                                                  const toml::table& node) {
    for (const Entry& entry : entries)
        if (entry.key == key) return entry.tables.front();
    record({std::string(key), {}, {}, false, false, {child(node, key_text(key))}});
    return entries.back().tables.front();
}

std::vector<std::string> ConfigTable::Impl::unread_keys() const {
    std::vector<std::pair<toml::source_index, std::string>> unread;
    for (const auto& [key, value] : *table) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
        unread.emplace_back(value.source().begin.line, std::string(key.str()));
    }
    std::stable_sort(unread.begin(), unread.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> keys;
    for (auto& [line, key] : unread) keys.push_back(std::move(key));
    return keys;
}

}  // namespace rockslope
