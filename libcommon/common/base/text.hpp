#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rockslope {

/// The shortest decimal text that reads back as the same double (std::to_chars).
std::string shortest_text(double value);

/// The double written in `text` (std::from_chars), with an optional leading '+'. Nothing if any character is
/// left over or the number is not finite.
std::optional<double> parse_number(std::string_view text);

/// The text with the characters escaped that have a meaning in XML and HTML: & < ".
std::string xml_escaped(std::string_view text);

/// The candidate nearest to a misspelt `word` by edit distance. Nothing if none is within a third of the
/// word's length.
std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> candidates);

}  // namespace rockslope
