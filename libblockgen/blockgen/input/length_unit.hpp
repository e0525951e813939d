#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rockslope::blockgen {

/// Metres in a length unit of maps and drawings, by the word that `unit` of a model file takes ("mm",
/// "us-ft"); nothing for another word.
std::optional<double> metres_in(std::string_view unit);

/// The word for a unit that a raster states as "metre", "US survey foot" and the like; the same text when it
/// is none of these.
std::string length_unit_word(const std::string& stated);

/// All words that metres_in() knows, with commas between them.
std::string length_unit_words();

}  // namespace rockslope::blockgen
