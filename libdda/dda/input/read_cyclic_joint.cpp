#include <cmath>
#include <utility>

#include "dda/input/read_joint_laws.hpp"
#include "dda/input/read_materials.hpp"
#include "dda/input/read_roughness_table.hpp"

namespace rockslope::dda {

namespace {

/// The backward advance has no strength of its own at the origin: it goes on from the forward return's, or
/// its first entry holds.
RoughnessTable with_continuous_start(RoughnessTable backward_advance, const RoughnessTable& forward_return,
                                     bool continuous) {
    if (continuous && backward_advance.entries.front().x > 0)
        backward_advance.entries.insert(backward_advance.entries.begin(), {0, forward_return.ratio(0)});
    return backward_advance;
}

void read_cycles(const ConfigTable& table, CyclicBartonBandis& law) {
    const bool continuous = table.choice("bridge", {"continuous", "clamp"}, "continuous") == "continuous";
    for (const ConfigTable& cycle : table.array_of_tables("cycle")) {
        CyclicBartonBandis::Cycle tables;
        tables.forward_advance = read_roughness_table(cycle, "forward_advance");
        tables.forward_return = read_roughness_table(cycle, "forward_return");
        tables.backward_advance = with_continuous_start(read_roughness_table(cycle, "backward_advance"),
                                                        tables.forward_return, continuous);
        tables.backward_return = read_roughness_table(cycle, "backward_return");
        law.cycles.push_back(std::move(tables));
    }
    if (law.cycles.empty())
        table.fail("cycle", "there is neither 'cycle' nor 'wear' in [" + table.path() + "]",
                   "an array of tables [[" + table.path() + ".cycle]], or 'wear'");
    law.further_cycle_factor = table.checked(
        "further_cycle_factor", table.number("further_cycle_factor", Dimension::none, 1),
        [](double v) { return v >= 0 && v <= 1; }, "a factor from 0 to 1");
    law.heal = table.boolean("heal", false);
}

/// One table for all branches, which resists motion both ways: the magnitudes count.
void read_wear(const ConfigTable& table, CyclicBartonBandis& law) {
    RoughnessTable wear = read_roughness_table(table, "wear");
    for (RoughnessTable::Entry& entry : wear.entries) entry.ratio = std::abs(entry.ratio);
    law.cycles = {{wear, wear, wear, wear}};
    law.unsigned_ratios = true;
    law.asymmetric = table.boolean("asymmetric", false);
    law.heal = table.boolean("heal", false);
}

}  // namespace

CyclicBartonBandis read_law(std::type_identity<CyclicBartonBandis>, const ConfigTable& table) {
    CyclicBartonBandis law;
    law.barton = read_barton_strength(table);
    law.peak_displacement = positive(table, "peak_displacement", Dimension::length);
    if (table.has("wear"))
        read_wear(table, law);
    else
        read_cycles(table, law);
    law.reversal_factor = table.checked(
        "reversal_factor", table.number("reversal_factor", Dimension::none, 1),
        [](double v) { return v >= 0 && v <= 1; }, "a factor from 0 to 1");
    law.min_slip = not_negative(table, "min_slip", Dimension::length, law.min_slip);
    law.damage = read_damage(table);
    law.floor_dilation = table.boolean("floor_dilation", false);
    law.contact_length = not_negative(table, "contact_length", Dimension::length, 0);
    return law;
}

}  // namespace rockslope::dda
