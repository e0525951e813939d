#include "record/stacked_blocks.hpp"

#include <algorithm>

namespace rockslope::record {

std::optional<Quantity> quantity_of_abbreviation(std::string_view word) {
    const std::string plain = lower_case(word);
    for (const Quantity quantity : {Quantity::acceleration, Quantity::velocity, Quantity::displacement}) {
        constexpr std::size_t shortest = 5;
        if (plain.size() >= shortest && quantity_name(quantity).starts_with(plain)) return quantity;
    }
    return std::nullopt;
}

const StackedBlock& choose_block(const std::vector<StackedBlock>& blocks,
                                 const RecordDeclaration& declaration, const RecordLines& lines) {
    if (blocks.empty())
        lines.fail(0, "the file has no time history", "acceleration, velocity or displacement");
    const auto has = [](Quantity quantity) {
        return [quantity](const StackedBlock& block) { return block.quantity == quantity; };
    };
    const bool any_acceleration = std::any_of(blocks.begin(), blocks.end(), has(Quantity::acceleration));
    const Quantity wanted =
        declaration.quantity.value_or(any_acceleration ? Quantity::acceleration : blocks.front().quantity);
    int channel = 0;
    for (const StackedBlock& block : blocks)
        if (block.quantity == wanted && ++channel == declaration.channel) return block;
    if (channel == 0)
        lines.fail(blocks.front().line, "the file holds no " + quantity_name(wanted),
                   quantity_name(wanted) + ", as the model file says");
    lines.fail(blocks.front().line,
               "there is no channel " + std::to_string(declaration.channel) + " in the file",
               "channel = 1" + (channel > 1 ? " to " + std::to_string(channel) : ""));
}

}  // namespace rockslope::record
