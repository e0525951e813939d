#include "dda/results/read_summary.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "common/base/input_error.hpp"
#include "common/base/read_file.hpp"

namespace rockslope::dda {

std::optional<WorstContact> read_worst_contact(const std::filesystem::path& summary) {
    using Json = nlohmann::json;
    const InputError invalid({summary.string()}, "is not a summary of dda-run",
                             "summary.json as the run wrote it");
    const Json json = Json::parse(read_text_file(summary), nullptr, false);
    if (json.is_discarded() || !json.is_object() || !json.contains("status")) throw invalid;
    if (!json.contains("worst_contact")) return std::nullopt;
    try {
        const Json& worst = json.at("worst_contact");
        WorstContact contact;
        const auto block = [&](const char* key) {
            const Json& value = worst.at(key);
            if (!value.is_number_unsigned() || value > std::numeric_limits<int>::max()) throw invalid;
            return value.get<int>();
        };
        contact.corner_block = block("corner_block");
        contact.edge_block = block("edge_block");
        contact.at = {worst.at("at").at(0).get<double>(), worst.at("at").at(1).get<double>()};
        contact.joint_material = worst.at("joint_material").get<std::string>();
        if (!contact.at.allFinite()) throw invalid;
        return contact;
    } catch (const Json::exception&) {
        throw invalid;
    }
}

}  // namespace rockslope::dda
