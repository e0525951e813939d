#include <algorithm>

#include "blockgen/input/domain.hpp"
#include "blockgen/input/height_line.hpp"
#include "blockgen/input/read_geology.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

void read_water_table(const ConfigTable& root, SlopeModel& model) {
    const auto table = root.optional_table("water_table");
    if (!table) return;
    const std::string expected = "points whose x grows from one side of the section to the other";
    model.water_table = read_line_across(*table, "line", expected, model);
    for (std::size_t k = 1; k < model.water_table.size(); ++k)
        if (model.water_table[k].x == model.water_table[k - 1].x)
            table->fail(table->has("line") ? "line" : "line_file",
                        "the water table has a step at x = " + shortest_text(model.water_table[k].x),
                        expected);
    const Bounds box = domain_bounds(model);
    const HeightLine within = height_line(model.water_table, box.low.x, box.high.x);
    if (std::all_of(within.begin(), within.end(), [&](const Point& p) { return p.y <= box.low.y; }))
        model.notes.push_back("the water table lies below the section: all of its rock is dry");
}

}  // namespace rockslope::blockgen
