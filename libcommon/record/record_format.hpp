#pragma once

#include <span>
#include <string>

#include "record/record_lines.hpp"
#include "record/records.hpp"

namespace rockslope::record {

/// A file format of records. The reader must check any text, because a declared format is not recognised
/// first.
struct RecordFormat {
    const char* key;       ///< its name in model files
    const char* name;      ///< for messages
    bool stacks_channels;  ///< a file may contain several channels
    bool (*recognises)(const RecordLines& lines);
    Record (*read)(const RecordLines& lines, const RecordDeclaration& declaration);
};

// The formats of record_formats.def. A new one is defined in its own file and has one line there.
#define RECORD_FORMAT(name) extern const RecordFormat name##_format;
#include "record/record_formats.def"
#undef RECORD_FORMAT

/// All formats, in the order in which they are tried.
std::span<const RecordFormat* const> record_formats();

/// @throws InputError at line `index` if the step is below 1e-6 s or the duration above 1e6 s.
void check_sampling(double dt, std::size_t count, const RecordLines& lines, std::size_t index);

/// Determines quantity and unit from what the file states (either may be empty) and from the declaration, and
/// converts the values to SI. @throws InputError at line `index` if neither states them or both disagree.
void resolve_units(Record& record, std::optional<Quantity> own_quantity, const std::string& own_unit,
                   const RecordDeclaration& declaration, const RecordLines& lines, std::size_t index);

}  // namespace rockslope::record
