#pragma once

#include <array>
#include <string>

#include "dda/record/record_lines.hpp"
#include "dda/record/records.hpp"

namespace dda {

/// One file format of records: does the text look like it, and its reader. A reader takes any text: a
/// declared format is not recognised first.
struct RecordFormat {
    const char* key;       ///< names it in model files
    const char* name;      ///< for messages
    bool stacks_channels;  ///< one file may hold several channels
    bool (*recognises)(const RecordLines& lines);
    Record (*read)(const RecordLines& lines, const RecordDeclaration& declaration);
};

bool is_peer(const RecordLines& lines);
Record read_peer(const RecordLines& lines, const RecordDeclaration& declaration);

bool is_knet(const RecordLines& lines);
Record read_knet(const RecordLines& lines, const RecordDeclaration& declaration);

bool is_cosmos(const RecordLines& lines);
Record read_cosmos(const RecordLines& lines, const RecordDeclaration& declaration);

bool is_csmip(const RecordLines& lines);
Record read_csmip(const RecordLines& lines, const RecordDeclaration& declaration);

bool is_esm(const RecordLines& lines);
Record read_esm(const RecordLines& lines, const RecordDeclaration& declaration);

bool is_geonet(const RecordLines& lines);
Record read_geonet(const RecordLines& lines, const RecordDeclaration& declaration);

bool is_smc(const RecordLines& lines);
Record read_smc(const RecordLines& lines, const RecordDeclaration& declaration);

bool is_sac(const RecordLines& lines);
Record read_sac(const RecordLines& lines, const RecordDeclaration& declaration);

/// Holds raw counts without the instrument's response: reading it always throws, and says what to do.
bool is_miniseed(const RecordLines& lines);
Record refuse_miniseed(const RecordLines& lines, const RecordDeclaration& declaration);

bool is_two_columns(const RecordLines& lines);
Record read_two_columns(const RecordLines& lines, const RecordDeclaration& declaration);

/// The table of formats, in the order of trial: a new format is two functions and one row.
inline constexpr std::array record_formats = {
    RecordFormat{"peer", "PEER (AT2, VT2, DT2)", false, is_peer, read_peer},
    RecordFormat{"knet", "K-NET or KiK-net", false, is_knet, read_knet},
    RecordFormat{"cosmos", "COSMOS V1.2", true, is_cosmos, read_cosmos},
    RecordFormat{"csmip", "CSMIP V2", true, is_csmip, read_csmip},
    RecordFormat{"esm", "ESM", false, is_esm, read_esm},
    RecordFormat{"geonet", "GeoNet V1A or V2A", true, is_geonet, read_geonet},
    RecordFormat{"smc", "USGS SMC", false, is_smc, read_smc},
    RecordFormat{"sac", "SAC", false, is_sac, read_sac},
    RecordFormat{"miniseed", "miniSEED", false, is_miniseed, refuse_miniseed},
    RecordFormat{"csv", "two columns (time, value)", false, is_two_columns, read_two_columns},
};

/// @throws InputError at line `index` when the step or the duration of a record is out of all proportion.
void check_sampling(double dt, std::size_t count, const RecordLines& lines, std::size_t index);

/// Settles what the values are, from the file's own words (either may be empty) and the declaration, at line
/// `index`, and multiplies them into SI. @throws InputError when nothing says it, or the two disagree.
void settle_units(Record& record, std::optional<Quantity> own_quantity, const std::string& own_unit,
                  const RecordDeclaration& declaration, const RecordLines& lines, std::size_t index);

}  // namespace dda
