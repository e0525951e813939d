// A plane wave rises through rock between free-field columns. It must propagate as in rock of infinite width.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/rock_mesh.hpp"

namespace rockslope::free_field_test {
namespace {

using namespace scene;
using namespace verification;

constexpr int columns = 8, rows = 30;
constexpr double pulse = 0.02;  // s: 25 blocks of a shear wave, 44 of a pressure wave
constexpr double step = 2e-4;   // s

/// Speed of a plane wave, without lateral strain, m/s.
double speed_of(const dda::Model& model, int axis) {
    const dda::Mat3 modulus = dda::elasticity(model.block_materials[0], dda::Plane::strain);
    return std::sqrt((axis == 0 ? modulus(2, 2) : modulus(0, 0)) / model.block_materials[0].density);
}

/// The motion of the surface at the left, in the middle and at the right, and of the row at half height.
struct Passage {
    double surface[3] = {};  ///< m/s, largest with its sign
    double arrival[3] = {};  ///< s, of the surface's pulse
    double half_way = 0;     ///< m/s, largest at half height on the way up
    double left_behind = 0;  ///< m/s, largest of any block after the wave has left
    double across = 0;       ///< m/s, largest component normal to the motion of the wave
    double speed = 0;        ///< m/s, wave speed
    double contact_frequency_step = 0;
};

Passage pass(int axis, RockMesh::Sides sides, const std::string& set_up) {
    const RockMesh mesh(columns, rows, sides);
    Passage passage;
    passage.speed = speed_of(mesh.s.model, axis);
    // Time for the wave to rise, to be reflected and to leave, with a margin.
    const double gone = 2.0 * rows / passage.speed + 1.5 * pulse;
    Simulation sim(mesh.s);
    const int stations[] = {mesh.block(0, rows - 1), mesh.block(columns / 2, rows - 1),
                            mesh.block(columns - 1, rows - 1)};
    double moment[3] = {}, energy[3] = {};
    sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
        const auto velocity = [&](int block) { return state.blocks.velocity[block]; };
        for (std::size_t k = 0; k < 3; ++k) {
            const double v = velocity(stations[k])[axis];
            if (std::abs(v) > std::abs(passage.surface[k])) passage.surface[k] = v;
            if (state.stage_time > gone) continue;
            moment[k] += state.stage_time * v * v;
            energy[k] += v * v;
        }
        const double v = velocity(mesh.block(columns / 2, rows / 2))[axis];
        if (state.stage_time < 0.5 * rows / passage.speed + pulse)
            passage.half_way = std::max(passage.half_way, v);
        for (int b = 0; b < columns * rows; ++b) {
            passage.across = std::max(passage.across, std::abs(velocity(b)[1 - axis]));
            if (state.stage_time > gone)
                passage.left_behind = std::max(passage.left_behind, std::abs(velocity(b)[axis]));
        }
    };
    EXPECT_EQ(sim.run(mesh.shaken(axis, pulse, gone + pulse, step)).status, dda::RunStatus::completed);
    for (std::size_t k = 0; k < 3; ++k) passage.arrival[k] = moment[k] / energy[k];
    passage.contact_frequency_step = sim.contact_frequency_step();
    expect_energy_balance("V32", set_up, sim);
    return passage;
}

// V32. The pulse of 1 m/s arrives at the surface after rows / speed and is doubled there within 3 %, also
// beside the columns, without motion normal to it. After its return to the base less than 3 % of it remains.
TEST(FreeField, TransmitsPlaneWavesUndistorted) {
    for (const int axis : {0, 1}) {
        const std::string set_up = std::string("free field at the sides, ") +
                                   (axis == 0 ? "shear" : "pressure") + " wave from below";
        const Passage p = pass(axis, RockMesh::Sides::free_field, set_up);
        const Case row = Case("V32", set_up, "required").contact_frequency_step(p.contact_frequency_step);
        const char* const places[] = {"left", "middle", "right"};
        // The centroids of the top blocks are half a block below the surface. The pulse and its reflection
        // pass them 1 m/c apart, symmetrically about the arrival at the surface.
        const double arrival = pulse / 2 + rows / p.speed;
        for (std::size_t k = 0; k < 3; ++k) {
            row.expect(std::string("velocity at the surface, ") + places[k], "m/s", p.surface[k], 2,
                       relative(0.03));
            row.expect(std::string("arrival, ") + places[k], "s", p.arrival[k], arrival, relative(0.03));
        }
        row.expect("velocity half-way", "m/s", p.half_way, 1, relative(0.03));
        row.expect_below("what is left of it", "m/s", p.left_behind, 0.03);
        row.expect_below("velocity across the wave", "m/s", p.across, 0.03);
    }
}

}  // namespace
}  // namespace rockslope::free_field_test
