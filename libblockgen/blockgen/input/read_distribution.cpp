#include "blockgen/input/read_distribution.hpp"

#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

const std::vector<std::pair<std::string, Law>>& laws() {
    static const std::vector<std::pair<std::string, Law>> list = {{"constant", Law::constant},
                                                                  {"uniform", Law::uniform},
                                                                  {"normal", Law::normal},
                                                                  {"lognormal", Law::lognormal},
                                                                  {"exponential", Law::exponential},
                                                                  {"weibull", Law::weibull},
                                                                  {"gamma", Law::gamma},
                                                                  {"power", Law::power}};
    return list;
}

Law read_law(const ConfigTable& table) {
    std::vector<std::string> words;
    for (const auto& [word, law] : laws()) words.push_back(word);
    const std::string word = table.choice("law", words);
    for (const auto& [candidate, law] : laws())
        if (candidate == word) return law;
    return Law::constant;
}

bool is_of_positive_values(Law law) {
    return law == Law::lognormal || law == Law::exponential || law == Law::weibull || law == Law::gamma;
}

void read_moments(const ConfigTable& table, Dimension dimension, Distribution& d) {
    const auto positive = [](double x) { return x > 0; };
    d.mean = table.number("mean", dimension);
    if (is_of_positive_values(d.law)) table.checked("mean", d.mean, positive, "a positive mean");
    if (d.law == Law::normal || d.law == Law::lognormal || d.law == Law::gamma)
        d.sd = table.checked(
            "sd", table.number("sd", dimension), [](double x) { return x >= 0; },
            "a standard deviation of zero or more");
    // Outside this range the quantile of the incomplete gamma function fails in double precision.
    if (d.law == Law::gamma)
        table.checked(
            "sd", d.sd, [&d](double sd) { return sd >= 1e-3 * d.mean && sd <= 30 * d.mean; },
            "a standard deviation from a thousandth to 30 times the mean");
    if (d.law == Law::weibull)
        d.shape = table.checked(
            "shape", table.number("shape"), [](double x) { return x >= 0.1 && x <= 1000; },
            "a shape from 0.1 to 1000; 1 is the exponential law");
}

void read_power(const ConfigTable& table, Dimension dimension, Distribution& d) {
    d.shape = table.checked(
        "exponent", table.number("exponent"), [](double x) { return x >= -20 && x <= 20; },
        "an exponent a of the density x^-a, usually 1 to 4");
    d.min = table.checked(
        "min", table.number("min", dimension), [](double x) { return x > 0; }, "a positive smallest value");
    d.max = table.number("max", dimension);
}

}  // namespace

Distribution read_distribution(const ConfigTable& parent, std::string_view key, Dimension dimension) {
    if (!parent.is_table(key)) return constant_value(parent.number(key, dimension));
    const ConfigTable table = parent.table(key);
    Distribution d;
    d.law = read_law(table);
    if (d.law == Law::constant) {
        d = constant_value(table.has("value") ? table.number("value", dimension)
                                              : table.number("mean", dimension));
        table.finish();
        return d;
    }
    if (d.law == Law::power) {
        read_power(table, dimension, d);
    } else {
        if (d.law != Law::uniform) read_moments(table, dimension, d);
        if (d.law == Law::uniform || table.has("min")) d.min = table.number("min", dimension);
        if (d.law == Law::uniform || table.has("max")) d.max = table.number("max", dimension);
    }
    if (!(d.min < d.max)) table.fail("max", "max is not above min", "max > min");
    if (!d.has_probability_mass())
        table.fail("mean", "the law has no probability between min and max", "bounds near the mean");
    table.finish();
    return d;
}

Distribution read_length(const ConfigTable& table, std::string_view key, bool may_be_zero) {
    const Distribution d = read_distribution(table, key, Dimension::length);
    if (d.infimum() < 0 || (d.infimum() == 0 && !may_be_zero && !is_of_positive_values(d.law)))
        table.fail(key,
                   d.law == Law::constant
                       ? "'" + std::string(key) + "' is " + shortest_text(d.mean) + " m, which is too small"
                       : "draws of " + std::string(key) + " may be zero or negative",
                   d.law == Law::constant ? (may_be_zero ? "zero or a positive length" : "a positive length")
                                          : "a min above zero");
    return d;
}

}  // namespace rockslope::blockgen
