#pragma once

#include <array>
#include <string_view>

namespace rockslope::verification {

/// One case of the catalogue as the report prints it.
struct CatalogueCase {
    std::string_view id;
    std::string_view title;
    std::string_view basis;  ///< the equation or source that the expected value comes from
    bool dynamic = true;     ///< whether its tests move blocks in time, and owe an energy balance
};

/// Every case that the report must list, in its order. A test names its id; a case without a row shows as
/// missing.
extern const std::array<CatalogueCase, 54> catalogue;

/// @return the case of that id. Throws std::out_of_range, naming the id, when there is none.
const CatalogueCase& catalogue_case(std::string_view id);

}  // namespace rockslope::verification
