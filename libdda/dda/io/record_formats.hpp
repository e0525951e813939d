#pragma once

#include <array>
#include <string>

#include "dda/io/record_lines.hpp"
#include "dda/io/records.hpp"

namespace dda {

/// One file format of records: does the text look like it, and its reader.
struct RecordFormat {
    const char* name;
    bool (*recognises)(const RecordLines& lines);
    Record (*read)(const RecordLines& lines, const RecordDeclaration& declaration);
};

bool is_peer(const RecordLines& lines);
Record read_peer(const RecordLines& lines, const RecordDeclaration& declaration);

bool is_two_columns(const RecordLines& lines);
Record read_two_columns(const RecordLines& lines, const RecordDeclaration& declaration);

/// The table of formats, in the order of trial: a new format is two functions and one row.
inline constexpr std::array record_formats = {
    RecordFormat{"PEER AT2", is_peer, read_peer},
    RecordFormat{"two columns", is_two_columns, read_two_columns},
};

/// @throws InputError at line `index` when the step or the duration of a record is out of all proportion.
void check_sampling(double dt, std::size_t count, const RecordLines& lines, std::size_t index);

/// Settles what the values are, from the file's own words (either may be empty) and the declaration, at line
/// `index`, and multiplies them into SI. @throws InputError when nothing says it, or the two disagree.
void settle_units(Record& record, std::optional<Quantity> own_quantity, const std::string& own_unit,
                  const RecordDeclaration& declaration, const RecordLines& lines, std::size_t index);

}  // namespace dda
