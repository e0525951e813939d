// Sixteen blocks on a stepped base that topple and slide: the limit equilibrium of Goodman and Bray.

#include <gtest/gtest.h>

#include <array>

#include "support/record.hpp"
#include "support/scene.hpp"
#include "support/threshold.hpp"

namespace {

using namespace scene;
using namespace verification;

constexpr int count = 16;
constexpr double dip = 30;       // of the blocks' bases, degrees
constexpr double width = 10;     // m
constexpr double riser = 1;      // m, of the stepped base
constexpr double weight = 25e3;  // N/m3

/// Block n counts from the toe, 1 to 16; the crest is on block 10.
double height(int n) {
    return n <= 10 ? 4. * n : 34 - 6. * (n - 11);
}

/// Forces between block n and the one below it, N, and the mode, from the crest's side down.
struct LimitEquilibrium {
    std::array<double, count + 1> force{};  ///< force[n] on the lower side of block n; [0] unused
    explicit LimitEquilibrium(double mu) {
        const double psi = radians(dip);
        double above = 0;
        for (int n = count; n >= 1; --n) {
            const double y = height(n);
            const double w = weight * width * y;
            const double upper = n < 10 ? y : y - 5;   // where the block above presses
            const double lower = n <= 10 ? y - 5 : y;  // where this one presses the block below
            const double topples =
                lower > 0
                    ? (above * (upper - width * mu) + w / 2 * (y * std::sin(psi) - width * std::cos(psi))) /
                          lower
                    : -1;
            const double slides = above - w * (std::cos(psi) * mu - std::sin(psi)) / (1 - mu * mu);
            above = std::max({topples, slides, 0.0});
            force[static_cast<std::size_t>(n)] = above;
        }
    }
};

/// The toe block needs no support at the limit.
double critical_friction() {
    const double mu = threshold(.7, .9, 40, [](double m) { return LimitEquilibrium(m).force[1] == 0; });
    return std::atan(mu) * 180 / std::numbers::pi;
}

class Slope {
  public:
    Slope() {
        Simulation sim(scene(70));
        EXPECT_EQ(sim.settle().status, dda::RunStatus::completed);
        glued_ = sim.state;
    }
    /// Stays, if in three seconds no block has moved by 5 cm: near the limit a block that stays moves by 2
    /// mm.
    bool holds(double phi) {
        Simulation sim(scene(phi));
        sim.state = glued_;
        EXPECT_EQ(sim.shake(3, 2.5e-4).status, dda::RunStatus::completed);
        frequency_step = sim.contact_frequency_step();
        double moved = 0;
        for (int n = 1; n <= count; ++n) moved = std::max(moved, sim.moved(block(n)).norm());
        force.fill(0);
        shear.fill(0);
        for (const dda::Contact& c : sim.state.contacts.contacts) {
            const int low = std::min(c.corner_block, c.edge_block);
            const int high = std::max(c.corner_block, c.edge_block);
            if (low < count || high != low + 1) continue;
            force[static_cast<std::size_t>(high - count + 1)] += c.normal_force;
            shear[static_cast<std::size_t>(high - count + 1)] += c.shear_force;
        }
        return moved < .05;
    }
    std::array<double, count + 1> force{};  ///< of the last run, as in LimitEquilibrium
    std::array<double, count + 1> shear{};  ///< on the same faces
    double frequency_step = 0;

  private:
    static int block(int n) { return count + n - 1; }

    static Scene scene(double phi) {
        Scene s;
        s.friction(phi);
        s.model.block_materials[0].density = weight / g;
        s.model.block_materials[0].youngs_modulus = 1e11;  // the limit equilibrium's blocks are rigid
        const double psi = radians(dip);
        const Vec2 up(std::cos(psi), std::sin(psi));
        const Vec2 out = dda::perpendicular(up);
        for (int n = 1; n <= count; ++n)
            s.box(width * (n - 1) * up - 20 * out, width, 20 + riser * (n - 1), dda::Motion::fixed, psi);
        for (int n = 1; n <= count; ++n)
            s.box(width * (n - 1) * up + riser * (n - 1) * out, width, height(n), dda::Motion::free, psi);
        return s;
    }
    dda::State glued_;
};

// V21. From the top down each block needs the larger of the forces that keep it from toppling and from
// sliding; at the limit the toe block needs none. The table's 38.152 degrees are recalled; the recursion
// gives them back.
TEST(LongToppling, FailsAtTheFrictionOfGoodmanAndBray) {
    const double critical = critical_friction();
    EXPECT_NEAR(critical, 38.152, 1e-3);
    Slope slope;
    ASSERT_FALSE(slope.holds(critical - 1));
    ASSERT_TRUE(slope.holds(critical + 1));
    const double found =
        threshold(critical - 1, critical + 1, 4, [&](double phi) { return slope.holds(phi); });
    Case limit("V21", "sixteen blocks", "required; found by halving to 0.13°");
    limit.contact_frequency_step(slope.frequency_step);
    limit.expect("φ at the limit", "°", found, critical, absolute(1));

    ASSERT_TRUE(slope.holds(found + .1));
    const LimitEquilibrium expected(.7855);
    EXPECT_NEAR(expected.force[7], 4837.0e3, 1e3);
    Case forces("V21", "sixteen blocks, 0.1° above the limit found",
                "required of the table; blocks 14 to 16 stand by themselves");
    forces.contact_frequency_step(slope.frequency_step);
    const std::string indeterminate =
        "Blocks 1 to 3 slide together, so nothing makes the friction on the faces between them full, as the "
        "limit "
        "equilibrium assumes. With the share that block 3's lower face bears, statics gives 1049 kN there. "
        "See the "
        "notes.";
    for (int n = 13; n >= 2; --n) {
        const auto k = static_cast<std::size_t>(n);
        const std::string quantity = "force below block " + std::to_string(n);
        const double ours = slope.force[k] / 1e3;
        const double theirs = expected.force[k] / 1e3;
        if (n > 3)
            forces.expect(quantity, "kN", ours, theirs, relative(.05));
        else
            forces.expect_miss(quantity, "kN", ours, theirs, relative(.05), indeterminate);
    }
    for (const int n : {4, 3, 2}) {
        const auto k = static_cast<std::size_t>(n);
        forces.inform("share of the friction borne by the lower face of block " + std::to_string(n), "",
                      std::abs(slope.shear[k]) / (slope.force[k] * std::tan(radians(found + .1))), 1);
    }
    for (const int n : {14, 15, 16})
        forces.expect_below("force below block " + std::to_string(n), "kN",
                            slope.force[static_cast<std::size_t>(n)] / 1e3, 1);
    Curve limit_forces{"limit equilibrium", {}, {}};
    Curve engine_forces{"engine, 0.1° above its limit", {}, {}};
    for (int n = 1; n <= count; ++n) {
        const auto k = static_cast<std::size_t>(n);
        limit_forces.x.push_back(n);
        limit_forces.y.push_back(expected.force[k] / 1e3);
        engine_forces.x.push_back(n);
        engine_forces.y.push_back(slope.force[k] / 1e3);
    }
    record_picture("V21", "forces", "V21: forces between the sixteen blocks at the limit",
                   "lower face of block", "normal force, kN", {limit_forces, engine_forces});
}

}  // namespace
