#pragma once

#include <span>
#include <string>

#include "record/record_lines.hpp"
#include "record/records.hpp"

namespace rockslope::record {

/// One file format of records: does the text look like it, and its reader. A reader takes any text: a
/// declared format is not recognised first.
struct RecordFormat {
    const char* key;       ///< names it in model files
    const char* name;      ///< for messages
    bool stacks_channels;  ///< one file may hold several channels
    bool (*recognises)(const RecordLines& lines);
    Record (*read)(const RecordLines& lines, const RecordDeclaration& declaration);
};

/// The formats: a new one is one file, which defines it, and its name here and in the table of records.cpp.
extern const RecordFormat peer_format, knet_format, cosmos_format, csmip_format, esm_format, geonet_format,
    smc_format, sac_format, run_history_format, two_columns_format;
/// Holds raw counts without the instrument's response: reading it always throws, and says what to do.
extern const RecordFormat miniseed_format;

/// All of them, in the order of trial.
std::span<const RecordFormat* const> record_formats();

/// @throws InputError at line `index` when the step or the duration of a record is out of all proportion.
void check_sampling(double dt, std::size_t count, const RecordLines& lines, std::size_t index);

/// Settles what the values are, from the file's own words (either may be empty) and the declaration, at line
/// `index`, and multiplies them into SI. @throws InputError when nothing says it, or the two disagree.
void resolve_units(Record& record, std::optional<Quantity> own_quantity, const std::string& own_unit,
                   const RecordDeclaration& declaration, const RecordLines& lines, std::size_t index);

}  // namespace rockslope::record
