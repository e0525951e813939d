#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rockslope::dda {

/// Physical quantity of a parameter; the table converts its units to SI.
enum class Quantity { number, length, angle, stress, velocity };

/// The parameters of one joint material, by key: what a joint law's `read` gets. The model file's table
/// [joint_material.NAME] implements it; a law does not depend on the file format. Every function throws
/// InputError with the place of a missing value, a wrong unit or a value out of range.
class ParameterTable {
  public:
    ParameterTable() = default;
    ParameterTable(const ParameterTable&) = delete;
    ParameterTable& operator=(const ParameterTable&) = delete;
    virtual ~ParameterTable() = default;

    /// Whether the table has the key.
    virtual bool has(std::string_view key) const = 0;
    /// Whether the key holds a text.
    virtual bool is_string(std::string_view key) const = 0;
    virtual const std::string& path() const = 0;  ///< of the table in its file, for messages

    /// A number in SI units, or the fallback if the key is missing. @throws InputError otherwise.
    virtual double number(std::string_view key, Quantity quantity) const = 0;
    virtual double number(std::string_view key, Quantity quantity, double fallback) const = 0;
    /// A number above zero in SI units. @throws InputError otherwise.
    virtual double positive(std::string_view key, Quantity quantity) const = 0;
    virtual double positive(std::string_view key, Quantity quantity, double fallback) const = 0;
    /// A number of zero or more in SI units. @throws InputError otherwise.
    virtual double not_negative(std::string_view key, Quantity quantity, double fallback) const = 0;
    /// true or false, or the fallback if the key is missing.
    virtual bool boolean(std::string_view key, bool fallback) const = 0;
    /// One of several words; the first of `choices` if the key is absent.
    virtual std::string choice(std::string_view key, const std::vector<std::string>& choices) const = 0;
    /// [[x, y], ...]
    virtual std::vector<std::array<double, 2>> pairs(std::string_view key) const = 0;
    virtual std::vector<std::unique_ptr<ParameterTable>> array_of_tables(std::string_view key) const = 0;

    /// Returns `value`, or throws when `accepted` refuses it. @param expected completes "expected ...".
    virtual double checked(std::string_view key, double value, const std::function<bool(double)>& accepted,
                           const std::string& expected) const = 0;
    /// @throws InputError about a key, always.
    [[noreturn]] virtual void fail(std::string_view key, const std::string& what,
                                   const std::string& expected) const = 0;

    /// A friction angle in [0, pi/2), rad.
    double friction_angle(std::string_view key) const;
    double friction_angle(std::string_view key, double fallback) const;
    /// The key `residual_friction_angle`, rad, at most the peak angle, which is its default.
    double residual_friction_angle(double peak) const;
    /// A factor in [0, 1], by default 1.
    double reduction_factor(std::string_view key) const;
};

}  // namespace rockslope::dda
