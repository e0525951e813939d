#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rockslope {

/// The shortest decimal text that reads back as the same double (std::to_chars).
std::string shortest_text(double value);

/// The double that the whole of `text` spells (std::from_chars); nothing when it spells none, or is not
/// finite.
std::optional<double> parse_number(std::string_view text);

/// The candidate nearest to a misspelt `word` by edit distance, when it is near enough to be meant; otherwise
/// nothing.
std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> candidates);

}  // namespace rockslope
