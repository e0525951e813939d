#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rockslope::record {

/// The physical quantity of a record's values.
enum class Quantity { acceleration, velocity, displacement };

/// A ground motion sampled at equal steps; the first sample is at time 0.
struct Record {
    double dt = 0;               ///< s
    std::vector<double> values;  ///< SI: m/s2, m/s or m
    Quantity quantity = Quantity::acceleration;
};

/// What the model file states about a record. A format that states quantity or unit itself must agree with
/// it.
struct RecordDeclaration {
    std::optional<Quantity> quantity = {};  ///< to select from a file with several; default acceleration
    std::string unit = {};                  ///< "g", "cm/s2", ...; empty: the unit stated by the file
    std::string format = {};                ///< one of record_format_keys(); empty: recognised by content
    int channel = 1;                        ///< channel of a file with several, from 1
    std::string point = {};                 ///< "crest x": point and direction in the history of a run
    std::optional<Quantity> assumed_quantity = {};  ///< used if neither the file nor `quantity` states it
};

/// Reads a record. The format is recognised by the content, never by the file name, unless it is declared.
/// @throws InputError with file and line: unreadable, unknown format, truncated, uneven steps, wrong count,
/// not a finite number, no such channel, quantity or unit stated neither by the file nor by the declaration.
Record read_record(const std::filesystem::path& path, const RecordDeclaration& declaration = {});
/// As read_record(), of a text. @param file_name for messages.
Record parse_record(std::string_view text, const std::string& file_name,
                    const RecordDeclaration& declaration = {});

/// The names of the formats in model files: "peer", "knet", ...
std::vector<std::string> record_format_keys();

/// The name of a quantity in model files and headings: "acceleration", "velocity", "displacement".
std::string quantity_name(Quantity quantity);
/// The quantity of such a name, in upper or lower case.
std::optional<Quantity> quantity_of_name(std::string_view name);

/// Factor from a unit to SI. Nothing if it is no unit of that quantity. Known: g, m/s2, cm/s2, mm/s2, gal;
/// m/s, cm/s, mm/s; m, cm, mm, in upper or lower case.
std::optional<double> record_unit_factor(Quantity quantity, std::string_view unit);

}  // namespace rockslope::record
