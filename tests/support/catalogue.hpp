#pragma once

#include <array>
#include <string_view>

namespace rockslope::verification {

/// A case of the verification catalogue, as printed in the report.
struct CatalogueCase {
    std::string_view id;
    std::string_view title;
    std::string_view basis;  ///< equation or source of the expected value
    bool dynamic = true;     ///< whether its tests have dynamic stages, which require an energy balance
};

/// All cases, in the order of the report. A test refers to a case by its id; a case without a row is reported
/// as not covered.
extern const std::array<CatalogueCase, 70> catalogue;

/// The case with this id. @throws std::out_of_range that names the id if there is none.
const CatalogueCase& catalogue_case(std::string_view id);

}  // namespace rockslope::verification
