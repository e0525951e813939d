#include "dda/input/read_roughness_table.hpp"

#include <cmath>

#include "common/base/text.hpp"

namespace rockslope::dda {

RoughnessTable read_roughness_table(const ConfigTable& table, std::string_view key) {
    RoughnessTable roughness;
    const auto refuse = [&](const std::string& what, const std::string& expected) {
        table.fail(key, "'" + std::string(key) + "' in [" + table.path() + "] " + what, expected);
    };
    for (const auto& [x, ratio] : table.pairs(key)) {
        const std::string where = "has the entry [" + shortest_text(x) + ", " + shortest_text(ratio) + "]";
        if (x < 0 || (!roughness.entries.empty() && x <= roughness.entries.back().x))
            refuse(where, "displacements over peak displacement that start at 0 or above and grow");
        if (std::abs(ratio) > 1) refuse(where, "a mobilised ratio from -1 to 1");
        roughness.entries.push_back({x, ratio});
    }
    if (roughness.entries.empty()) refuse("is empty", "at least one pair [x, ratio]");
    return roughness;
}

}  // namespace rockslope::dda
