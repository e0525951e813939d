#include "dda/results/read_summary.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "common/base/input_error.hpp"
#include "common/base/read_file.hpp"

namespace rockslope::dda {

namespace {

using SummaryJson = nlohmann::json;

InputError invalid_summary(const std::filesystem::path& summary) {
    return {{summary.string()}, "is not a summary of dda-run", "summary.json as the run wrote it"};
}

SummaryJson read_json(const std::filesystem::path& summary) {
    SummaryJson json = SummaryJson::parse(read_text_file(summary), nullptr, false);
    if (json.is_discarded() || !json.is_object() || !json.contains("status")) throw invalid_summary(summary);
    return json;
}

}  // namespace

std::string read_status(const std::filesystem::path& summary) {
    const SummaryJson json = read_json(summary);
    if (!json.at("status").is_string()) throw invalid_summary(summary);
    return json.at("status").get<std::string>();
}

std::optional<double> read_factor_of_safety(const std::filesystem::path& summary) {
    const SummaryJson json = read_json(summary);
    if (!json.contains("factor_of_safety")) return std::nullopt;
    try {
        const SummaryJson& stands = json.at("factor_of_safety").at("stands");
        const SummaryJson& fails = json.at("factor_of_safety").at("fails");
        if (stands.is_null() || fails.is_null()) return std::nullopt;
        return std::sqrt(stands.get<double>() * fails.get<double>());
    } catch (const SummaryJson::exception&) {
        throw invalid_summary(summary);
    }
}

std::optional<WorstContact> read_worst_contact(const std::filesystem::path& summary) {
    const InputError invalid = invalid_summary(summary);
    const SummaryJson json = read_json(summary);
    if (!json.contains("worst_contact")) return std::nullopt;
    try {
        const SummaryJson& worst = json.at("worst_contact");
        WorstContact contact;
        const auto block = [&](const char* key) {
            const SummaryJson& value = worst.at(key);
            if (!value.is_number_unsigned() || value > std::numeric_limits<int>::max()) throw invalid;
            return value.get<int>();
        };
        contact.corner_block = block("corner_block");
        contact.edge_block = block("edge_block");
        contact.at = {worst.at("at").at(0).get<double>(), worst.at("at").at(1).get<double>()};
        contact.joint_material = worst.at("joint_material").get<std::string>();
        if (!contact.at.allFinite()) throw invalid;
        return contact;
    } catch (const SummaryJson::exception&) {
        throw invalid;
    }
}

}  // namespace rockslope::dda
