#pragma once

#include <string>

#include "record/records.hpp"
#include "support/error_of.hpp"

namespace rockslope::record {

/// The error of reading a record.
inline std::string error_in(const std::string& text, const RecordDeclaration& declaration = {}) {
    return error_of([&] { parse_record(text, "r", declaration); });
}

}  // namespace rockslope::record
