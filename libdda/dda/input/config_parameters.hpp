#pragma once

#include "common/config/config_table.hpp"
#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

/// The parameters of a joint law in a table [joint_material.NAME] of a model file. The keys that a law reads
/// are the keys that the table may have.
class ConfigParameters final : public ParameterTable {
  public:
    explicit ConfigParameters(const ConfigTable& table) : table_(table) {}

    bool has(std::string_view key) const override { return table_.has(key); }
    bool is_string(std::string_view key) const override { return table_.is_string(key); }
    const std::string& path() const override { return table_.path(); }
    double number(std::string_view key, Quantity quantity) const override;
    double number(std::string_view key, Quantity quantity, double fallback) const override;
    double positive(std::string_view key, Quantity quantity) const override;
    double positive(std::string_view key, Quantity quantity, double fallback) const override;
    double not_negative(std::string_view key, Quantity quantity, double fallback) const override;
    bool boolean(std::string_view key, bool fallback) const override;
    std::string choice(std::string_view key, const std::vector<std::string>& choices) const override;
    std::vector<std::array<double, 2>> pairs(std::string_view key) const override;
    std::vector<std::unique_ptr<ParameterTable>> array_of_tables(std::string_view key) const override;
    double checked(std::string_view key, double value, const std::function<bool(double)>& accepted,
                   const std::string& expected) const override;
    [[noreturn]] void fail(std::string_view key, const std::string& what,
                           const std::string& expected) const override;

  private:
    ConfigTable table_;
};

}  // namespace rockslope::dda
