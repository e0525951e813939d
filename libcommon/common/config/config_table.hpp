#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/base/input_error.hpp"

namespace rockslope {

/// The physical dimension of a value in a model file. A bare number is in SI units. A string may carry one of
/// the units of the dimension. An angle needs a unit, "deg" or "rad"; a bare non-zero number is an error.
enum class Dimension {
    none,
    length,           // m, mm, cm, km
    angle,            // deg, rad; returned in radians
    time,             // s, ms, min
    mass_density,     // kg/m3, t/m3, g/cm3
    stress,           // Pa, kPa, MPa, GPa
    stiffness,        // N/m per metre of thickness (a penalty): N/m, kN/m, MN/m, GN/m, and Pa, kPa, MPa, GPa
    joint_stiffness,  // Pa/m, kPa/m, MPa/m, GPa/m
    acceleration,     // m/s2, cm/s2, gal, g (9.80665 m/s2)
    velocity,         // m/s, cm/s, mm/s
    force,            // N, kN, MN
    frequency         // Hz, rad/s
};

/// A strict view of one table of a TOML model file. It records which keys are read; finish() rejects unread
/// keys and suggests the nearest known key. All errors are InputError with file, line and column. Values
/// that are not finite or exceed 1e30 are rejected; the caller checks narrower ranges with `checked`. Copies
/// share one view.
///
/// An `expected` text completes "expected ...": "a positive number", not "must be positive".
class ConfigTable {
  public:
    /// Reads and parses a file, then applies the overrides `key.path=value` of the command line. A value
    /// that is not TOML syntax (a bare word, 35 deg) is taken as a string. stage[1].step is a key of the
    /// second [[stage]]. Missing tables of the path are made. @throws InputError for unreadable files and
    /// syntax errors.
    static ConfigTable from_file(const std::filesystem::path& path,
                                 const std::vector<std::string>& overrides = {});
    /// As from_file(), of a text. @param file_name for messages.
    static ConfigTable from_text(std::string_view text, const std::string& file_name,
                                 const std::vector<std::string>& overrides = {});

    /// Whether the key is there.
    bool has(std::string_view key) const;
    /// Location of the value of a key, or of the table when the key is absent.
    SourceLocation place(std::string_view key = {}) const;
    /// Dotted path of this table in its file ("stage[1].base_motion"), for messages.
    const std::string& path() const;

    /// A number in SI units. @throws InputError for another type, a unit of another dimension, or a missing
    /// key.
    double number(std::string_view key, Dimension dimension = Dimension::none) const;
    double number(std::string_view key, Dimension dimension, double fallback) const;
    /// A whole number. @throws InputError for another type or a missing key.
    std::int64_t integer(std::string_view key) const;
    std::int64_t integer(std::string_view key, std::int64_t fallback) const;
    /// true or false, or the fallback if the key is missing. @throws InputError for another type.
    bool boolean(std::string_view key, bool fallback) const;
    /// A text. @throws InputError for another type or a missing key.
    std::string string(std::string_view key) const;
    std::string string(std::string_view key, std::string_view fallback) const;
    /// A string that must be one of `choices`. The error suggests the nearest one.
    std::string choice(std::string_view key, const std::vector<std::string>& choices) const;
    std::string choice(std::string_view key, const std::vector<std::string>& choices,
                       std::string_view fallback) const;
    /// [x, y]
    std::array<double, 2> pair(std::string_view key, Dimension dimension = Dimension::none) const;
    std::array<double, 2> pair(std::string_view key, Dimension dimension,
                               std::array<double, 2> fallback) const;
    /// [[x, y], ...]
    std::vector<std::array<double, 2>> pairs(std::string_view key,
                                             Dimension dimension = Dimension::none) const;
    /// An array of numbers in SI units. @throws InputError for another type or a missing key.
    std::vector<double> numbers(std::string_view key, Dimension dimension = Dimension::none) const;
    /// An array of texts. @throws InputError for another type or a missing key.
    std::vector<std::string> strings(std::string_view key) const;
    /// The values of an array, each as TOML text. @throws InputError for another type or a missing key.
    std::vector<std::string> value_texts(std::string_view key) const;
    /// A list of rings, [[[x, y], ...], ...]; empty when the key is absent.
    std::vector<std::vector<std::array<double, 2>>> rings(std::string_view key) const;

    /// Whether the key holds a table, not a number, string or array.
    bool is_table(std::string_view key) const;
    /// Whether the key holds a text.
    bool is_string(std::string_view key) const;
    ConfigTable table(std::string_view key) const;  ///< error when absent
    /// The table of this key, if there is one. @throws InputError for another type.
    std::optional<ConfigTable> optional_table(std::string_view key) const;
    ConfigTable table_or_empty(std::string_view key) const;  ///< a table without keys when absent
    std::vector<ConfigTable> array_of_tables(std::string_view key) const;  ///< empty when absent
    /// The unread sub-tables by name, in the order of the file, for [block_material.*]. Marks them read.
    std::vector<std::pair<std::string, ConfigTable>> named_tables() const;

    /// An absolute path. A relative one in the model file is relative to the folder of that file; one in an
    /// override is relative to the working directory.
    std::filesystem::path file_path(std::string_view key) const;

    /// Returns `value` if `accepted` is true for it. @throws InputError at the location of the key otherwise.
    double checked(std::string_view key, double value, const std::function<bool(double)>& accepted,
                   const std::string& expected) const;
    [[noreturn]] void fail(std::string_view key, const std::string& what, const std::string& expected) const;

    /// @throws InputError for the first unread key of this table and of the tables read through it.
    void finish() const;

    /// TOML text that reads back to the same values: the tables and keys read so far, in the order of
    /// reading, with the defaults of absent keys. Paths of files are written relative to `folder`, or
    /// absolute when it is empty.
    std::string effective_text(const std::filesystem::path& folder = {}) const;

    /// As effective_text(), with no mark at defaults, and with the name that a function gives to each file in
    /// place of its path: with their digests, equal texts mean equal input wherever the files are.
    std::string effective_text(
        const std::function<std::string(const std::filesystem::path&)>& name_of_file) const;

    struct Impl;
    explicit ConfigTable(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}

  private:
    std::shared_ptr<Impl> impl_;
};

}  // namespace rockslope
