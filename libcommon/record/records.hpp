#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rockslope::record {

/// What the values of a record are.
enum class Quantity { acceleration, velocity, displacement };

/// A ground motion sampled at equal steps; the first sample is at time 0.
struct Record {
    double dt = 0;               ///< s
    std::vector<double> values;  ///< SI: m/s2, m/s or m
    Quantity quantity = Quantity::acceleration;
};

/// What the model file says of a record. Formats that state quantity or unit themselves are checked against
/// it.
struct RecordDeclaration {
    std::optional<Quantity> quantity = {};  ///< of a file that holds several: which; without it, acceleration
    std::string unit = {};                  ///< "g", "cm/s2", ...; empty: the file's own
    std::string format = {};                ///< one of record_format_keys(); empty: told from the content
    int channel = 1;                        ///< which channel of a file that stacks several, from 1
    std::string point = {};                 ///< "crest x": of a run's history, a point and a direction
    std::optional<Quantity> assumed_quantity = {};  ///< where neither the file nor `quantity` says it
};

/// Reads a record. The format is told from the content, never from the name, unless it is declared.
/// @throws InputError naming file and line: unreadable, unknown format, truncated, uneven steps, wrong count,
/// not a finite number, no such channel, neither file nor declaration says what the values are.
Record read_record(const std::filesystem::path& path, const RecordDeclaration& declaration = {});
Record parse_record(std::string_view text, const std::string& file_name,
                    const RecordDeclaration& declaration = {});

/// The words by which a model file may name a format: "peer", "knet", ...
std::vector<std::string> record_format_keys();

/// The word of a quantity in model files and headings: "acceleration", "velocity", "displacement".
std::string quantity_name(Quantity quantity);
std::optional<Quantity> quantity_of_name(std::string_view name);

/// The factor from a unit to SI; nothing when the unit does not measure that quantity. Known: g, m/s2, cm/s2,
/// mm/s2, gal; m/s, cm/s, mm/s; m, cm, mm. Upper and lower case alike.
std::optional<double> record_unit_factor(Quantity quantity, std::string_view unit);

}  // namespace rockslope::record
