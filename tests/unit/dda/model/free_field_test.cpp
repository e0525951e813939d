#include "dda/model/free_field.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/error_of.hpp"
#include "support/rock_mesh.hpp"

namespace rockslope::free_field_test {
namespace {

using namespace scene;

TEST(FreeField, HasTheLayersOfTheFacesInAnyOrder) {
    Scene s;
    s.box({0, 2}, 3, 1.5);
    s.box({0, 0}, 3, 2);
    // Left sides run downwards; the upper quarter of the lower one is missing.
    const std::vector<dda::FacePart> left = {{3, 0, 1}, {7, 0.25, 1}};
    const dda::FreeField field = dda::make_free_field(s.model, {left.data(), 1}, "below", 1);
    EXPECT_EQ(field.nodes, (std::vector<double>{2, 2.75, 3.5}));
    EXPECT_EQ(field.rock, (std::vector<dda::BlockIndex>{0, 0}));
    EXPECT_THROW(dda::make_free_field(s.model, left, "below", 0), std::invalid_argument) << "a gap";
    const std::vector<dda::FacePart> whole = {{3, 0, 1}, {7, 0, 1}};
    const dda::FreeField both = dda::make_free_field(s.model, whole, "below", 0);
    EXPECT_EQ(both.nodes, (std::vector<double>{0, 2, 3.5}));
    EXPECT_EQ(both.rock, (std::vector<dda::BlockIndex>{1, 0}));
    EXPECT_THROW(dda::make_free_field(s.model, {}, "below", 0), std::invalid_argument);
    const std::vector<dda::FacePart> base = {{4, 0, 1}};
    EXPECT_THROW(dda::make_free_field(s.model, base, "below", 0), std::invalid_argument) << "level";
}

// A static stage keeps the columns at rest, a dynamic one moves them.
TEST(FreeField, MovesInDynamicStagesOnly) {
    const RockMesh mesh(2, 4, RockMesh::Sides::free_field);
    dda::Stage whole = mesh.shaken(0, 4e-3, 6e-3, 2e-4);
    Simulation once(mesh.s);
    ASSERT_EQ(once.run(whole).status, dda::RunStatus::completed);
    const dda::ColumnMotion& column = once.state.free_fields.at(1);
    EXPECT_TRUE(once.state.free_fields.at(0).velocity.empty())
        << "the boundary at the base has no free field";
    ASSERT_EQ(column.velocity.size(), 5u);
    EXPECT_GT(column.velocity.back().norm(), 0.1);
    for (std::size_t k = 0; k < 5; ++k)
        EXPECT_NEAR((column.velocity[k] - once.state.free_fields.at(2).velocity[k]).norm(), 0, 1e-12);

    Simulation settled(mesh.s);
    dda::Stage rest;
    rest.kind = dda::StageKind::static_equilibrium;
    rest.step_limit = 3;
    settled.run(rest);
    EXPECT_TRUE(settled.state.free_fields.at(1).velocity.back().isZero(0));
}

// An incident wave of velocity v exerts the traction z v.
TEST(FreeField, AStressWaveIsAVelocityTimesTheImpedance) {
    const RockMesh mesh(2, 4, RockMesh::Sides::free_field);
    dda::Stage velocity = mesh.shaken(1, 4e-3, 6e-3, 2e-4);
    dda::Stage stress = velocity;
    const dda::Mat3 modulus = dda::elasticity(mesh.s.model.block_materials[0], dda::Plane::strain);
    const double impedance = std::sqrt(mesh.s.model.block_materials[0].density * modulus(0, 0));
    std::vector<double> values = velocity.incident_waves[0].y.values();
    for (double& value : values) value *= impedance;
    stress.incident_waves[0].y = {velocity.incident_waves[0].y.times(), values};
    stress.incident_waves[0].y_is_traction = true;
    Simulation a(mesh.s), b(mesh.s);
    ASSERT_EQ(a.run(velocity).status, dda::RunStatus::completed);
    ASSERT_EQ(b.run(stress).status, dda::RunStatus::completed);
    for (int block = 0; block < a.model.block_count(); ++block) {
        EXPECT_GT(a.velocity(block).norm(), 0.01);
        EXPECT_NEAR((a.velocity(block) - b.velocity(block)).norm(), 0, 1e-9);
    }
}

}  // namespace
}  // namespace rockslope::free_field_test
