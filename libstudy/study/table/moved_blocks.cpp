#include "study/table/moved_blocks.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"
#include "study/csv/csv_text.hpp"

namespace rockslope::study {

namespace {

/// What is needed of a block.
struct Block {
    double dx = 0, dy = 0, area = 0;
    double left_x = 0, left_y = 0, right_x = 0, right_y = 0, top_x = 0, top_y = 0;
};

std::vector<Block> read_blocks(const std::filesystem::path& file) {
    const TextTable table = read_csv(file);
    const auto column = [&](const char* name) {
        const auto found = table.find(name);
        if (!found)
            throw InputError({file.string(), 1}, std::string("has no column '") + name + "'",
                             "the table of dda-run");
        return *found;
    };
    const std::vector<std::size_t> columns = {column("relative displacement x"),
                                              column("relative displacement y"),
                                              column("area"),
                                              column("leftmost x"),
                                              column("leftmost y"),
                                              column("rightmost x"),
                                              column("rightmost y"),
                                              column("highest x at the start"),
                                              column("highest y at the start")};
    std::vector<Block> blocks;
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        double values[9];
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const auto value = parse_number(table.rows[k][columns[i]]);
            if (!value)
                throw InputError({file.string(), static_cast<int>(k) + 2},
                                 "'" + table.rows[k][columns[i]] + "' is no number", "a number");
            values[i] = *value;
        }
        blocks.push_back({values[0], values[1], values[2], values[3], values[4], values[5], values[6],
                          values[7], values[8]});
    }
    return blocks;
}

}  // namespace

MovedBlocks moved_blocks(const std::filesystem::path& block_table, double limit) {
    std::vector<Block> moved;
    MovedBlocks result;
    double direction = 0;
    for (const Block& block : read_blocks(block_table)) {
        if (!(std::hypot(block.dx, block.dy) > limit)) continue;
        moved.push_back(block);
        result.volume += block.area;
        direction += block.area * block.dx;
    }
    if (moved.empty()) return result;
    const bool to_the_right = direction >= 0;
    const Block* front = &moved.front();
    const Block* top = front;
    for (const Block& block : moved) {
        const bool is_ahead = to_the_right ? block.right_x > front->right_x : block.left_x < front->left_x;
        if (is_ahead) front = &block;
        if (block.top_y > top->top_y) top = &block;
    }
    const double x = to_the_right ? front->right_x : front->left_x;
    const double y = to_the_right ? front->right_y : front->left_y;
    result.front = x;
    result.run_out = std::abs(x - top->top_x);
    result.travel_angle = std::atan2(top->top_y - y, *result.run_out);
    return result;
}

}  // namespace rockslope::study
