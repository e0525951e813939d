#include "dda/input/config_parameters.hpp"

#include "dda/input/read_materials.hpp"

namespace rockslope::dda {

namespace {

Dimension dimension_of(Quantity quantity) {
    switch (quantity) {
        case Quantity::number:
            return Dimension::none;
        case Quantity::length:
            return Dimension::length;
        case Quantity::angle:
            return Dimension::angle;
        case Quantity::stress:
            return Dimension::stress;
        case Quantity::velocity:
            return Dimension::velocity;
    }
    return Dimension::none;
}

}  // namespace

double ConfigParameters::number(std::string_view key, Quantity quantity) const {
    return table_.number(key, dimension_of(quantity));
}

double ConfigParameters::number(std::string_view key, Quantity quantity, double fallback) const {
    return table_.number(key, dimension_of(quantity), fallback);
}

double ConfigParameters::positive(std::string_view key, Quantity quantity) const {
    return dda::positive(table_, key, dimension_of(quantity));
}

double ConfigParameters::positive(std::string_view key, Quantity quantity, double fallback) const {
    return dda::positive(table_, key, dimension_of(quantity), fallback);
}

double ConfigParameters::not_negative(std::string_view key, Quantity quantity, double fallback) const {
    return dda::not_negative(table_, key, dimension_of(quantity), fallback);
}

bool ConfigParameters::boolean(std::string_view key, bool fallback) const {
    return table_.boolean(key, fallback);
}

std::string ConfigParameters::choice(std::string_view key, const std::vector<std::string>& choices) const {
    return table_.choice(key, choices, choices.front());
}

std::vector<std::array<double, 2>> ConfigParameters::pairs(std::string_view key) const {
    return table_.pairs(key);
}

std::vector<std::unique_ptr<ParameterTable>> ConfigParameters::array_of_tables(std::string_view key) const {
    std::vector<std::unique_ptr<ParameterTable>> tables;
    for (const ConfigTable& table : table_.array_of_tables(key))
        tables.push_back(std::make_unique<ConfigParameters>(table));
    return tables;
}

double ConfigParameters::checked(std::string_view key, double value,
                                 const std::function<bool(double)>& accepted,
                                 const std::string& expected) const {
    return table_.checked(key, value, accepted, expected);
}

void ConfigParameters::fail(std::string_view key, const std::string& what,
                            const std::string& expected) const {
    table_.fail(key, what, expected);
}

}  // namespace rockslope::dda
