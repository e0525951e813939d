// Sixteen blocks topple and slide on a stepped base: the limit equilibrium of Goodman and Bray.

#include <gtest/gtest.h>

#include <array>

#include "support/case_name.hpp"
#include "support/energy_balance.hpp"
#include "support/penalty_series.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"
#include "support/threshold.hpp"

namespace rockslope::toppling_test {
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

/// The forces between block n and the one below it, N, and the modes, computed from the uppermost block down.
/// A horizontal acceleration of k g acts out of the slope.
struct LimitEquilibrium {
    std::array<double, count + 1> force{};  ///< force[n] on the lower side of block n; [0] unused
    explicit LimitEquilibrium(double mu, double k = 0) {
        const double psi = radians(dip);
        const double down = std::sin(psi) + k * std::cos(psi);  // of a unit weight, along the bases
        const double onto = std::cos(psi) - k * std::sin(psi);  // and normal to them
        double above = 0;
        for (int n = count; n >= 1; --n) {
            const double y = height(n);
            const double w = weight * width * y;
            const double upper = n < 10 ? y : y - 5;   // height of the force of the block above
            const double lower = n <= 10 ? y - 5 : y;  // height of the force on the block below
            const double topples =
                lower > 0 ? (above * (upper - width * mu) + w / 2 * (y * down - width * onto)) / lower : -1;
            const double slides = above - w * (onto * mu - down) / (1 - mu * mu);
            above = std::max({topples, slides, 0.0});
            force[n] = above;
        }
    }
};

/// The friction angle at which the toe block needs no support.
double critical_friction(double k = 0) {
    const double mu = threshold(.7, .97, 40, [k](double m) { return LimitEquilibrium(m, k).force[1] == 0; });
    return std::atan(mu) * 180 / std::numbers::pi;
}

class Slope {
  public:
    /// @param tension N, constant, of a horizontal bolt from the middle of block 1 into the slope.
    /// @param k horizontal acceleration out of the slope, over g, to which a run rises in a second.
    explicit Slope(double tension = 0, const ContactSetting& setting = {.5}, double k = 0)
        : tension_(tension), setting_(setting), k_(k) {
        Simulation sim(scene(70));
        EXPECT_EQ(sim.settle().status, dda::RunStatus::completed);
        settled_ = sim.state;
    }
    /// Whether no block moves by 5 cm in three seconds. A stable block near the limit moves by 2 mm.
    bool holds(double phi) {
        run(phi, 3);
        return moved < .05;
    }
    /// Whether all blocks come to rest within six seconds, with any displacement.
    bool stops(double phi) {
        run(phi, 6);
        return speed < 1e-3;
    }
    void run(double phi, double duration, double step = 2.5e-4) {
        Simulation sim(scene(phi));
        sim.state = settled_;
        EXPECT_EQ(sim.shake(duration, step).status, dda::RunStatus::completed);
        frequency_step = sim.contact_frequency_step();
        energy = sim.energy;
        moved = speed = 0;
        for (int n = 1; n <= count; ++n) {
            moved = std::max(moved, sim.moved(block(n)).norm());
            speed = std::max(speed, sim.velocity(block(n)).head<2>().norm());
        }
        force.fill(0);
        shear.fill(0);
        for (const dda::Contact& c : sim.state.contacts.contacts) {
            const int low = std::min(c.corner_block, c.edge_block).value();
            const int high = std::max(c.corner_block, c.edge_block).value();
            if (low < count || high != low + 1) continue;
            const auto upper = static_cast<std::size_t>(high) + 1 - count;
            force[upper] += c.normal_force;
            shear[upper] += c.shear_force;
        }
    }
    double moved = 0;                       ///< m, largest displacement of a block in the last run
    double speed = 0;                       ///< m/s, largest velocity of a block at its end
    std::array<double, count + 1> force{};  ///< of the last run, as in LimitEquilibrium
    std::array<double, count + 1> shear{};  ///< on the same faces
    double frequency_step = 0;
    std::optional<EnergyMonitor> energy;  ///< of the last run

  private:
    static int block(int n) { return count + n - 1; }

    Scene scene(double phi) const {
        Scene s;
        s.friction(phi);
        s.model.block_materials[0].density = weight / g;
        s.model.block_materials[0].youngs_modulus = 1e11;  // the limit equilibrium's blocks are rigid
        setting_.apply(s);
        if (k_ > 0)
            s.model.loads.push_back(
                dda::BodyLoad{dda::BlockIndex::none(), {-k_ * g, 0}, dda::TimeTable({0, 1, 100}, {0, 1, 1})});
        const double psi = radians(dip);
        const Vec2 up(std::cos(psi), std::sin(psi));
        const Vec2 out = dda::perpendicular(up);
        for (int n = 1; n <= count; ++n)
            s.box(width * (n - 1) * up - 20 * out, width, 20 + riser * (n - 1), dda::Motion::fixed, psi);
        for (int n = 1; n <= count; ++n)
            s.box(width * (n - 1) * up + riser * (n - 1) * out, width, height(n), dda::Motion::free, psi);
        if (tension_ > 0) {
            // A long bolt of very small stiffness: the motion of the block changes neither its tension nor
            // its direction.
            const Vec2 middle = width / 2 * up + height(1) / 2 * out;
            s.model.bolts.push_back({"bolt", s.material_point(count - 1, middle + Vec2(1000, 0)),
                                     s.material_point(block(1), middle), 1.0, tension_, 0});
        }
        return s;
    }
    double tension_;
    ContactSetting setting_;
    double k_;
    dda::State settled_;
};

// V21. From the top down, each block needs the larger of the forces that prevent toppling and sliding. At the
// limit the toe block needs no force. The recursion reproduces the 38.152 degrees of the table. The forces
// are those of the limit only near it: 0.1° above it the friction is no longer full, and the state in which
// the slope was settled moves them by 6 %. 0.02° above it they differ by 1 to 3 %.
TEST(LongToppling, FailsAtTheFrictionOfGoodmanAndBray) {
    constexpr double margin = .02;
    const double critical = critical_friction();
    EXPECT_NEAR(critical, 38.152, 1e-3);
    Slope slope;
    ASSERT_FALSE(slope.holds(critical - 1));
    ASSERT_TRUE(slope.holds(critical + 1));
    const double found =
        threshold(critical - 1, critical + 1, 7, [&](double phi) { return slope.holds(phi); });
    Case limit("V21", "sixteen blocks", "required; found by halving to 0.02°");
    limit.contact_frequency_step(slope.frequency_step);
    limit.expect("φ at the limit", "°", found, critical, absolute(1));

    ASSERT_TRUE(slope.holds(found + margin));
    const LimitEquilibrium expected(.7855);
    EXPECT_NEAR(expected.force[7], 4837.0e3, 1e3);
    Case forces("V21", "sixteen blocks, 0.02° above the limit found",
                "required of the table; blocks 14 to 16 stand by themselves");
    forces.contact_frequency_step(slope.frequency_step);
    expect_energy_balance("V21", "sixteen blocks, 0.02° above the limit found", *slope.energy,
                          slope.frequency_step);
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
            forces.expect_miss(quantity, "kN", ours, theirs,
                               {.tolerance = relative(.05), .reason = indeterminate});
    }
    for (const int n : {4, 3, 2}) {
        const auto k = static_cast<std::size_t>(n);
        forces.inform("share of the friction borne by the lower face of block " + std::to_string(n), "",
                      std::abs(slope.shear[k]) / (slope.force[k] * std::tan(radians(found + margin))), 1);
    }
    for (const int n : {14, 15, 16})
        forces.expect_below("force below block " + std::to_string(n), "kN", slope.force[n] / 1e3, 1);
    Curve limit_forces{"limit equilibrium", {}, {}};
    Curve engine_forces{"engine, 0.02° above its limit", {}, {}};
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

/// Runs the slope, which must stand, and compares the forces between its toppling blocks with the table's.
void expect_forces_of_the_table(Slope& slope, const std::string& set_up, double phi) {
    EXPECT_TRUE(slope.holds(phi)) << set_up;
    expect_energy_balance("V21", set_up, *slope.energy, slope.frequency_step);
    Case forces("V21", set_up, "required of the table");
    forces.contact_frequency_step(slope.frequency_step);
    const LimitEquilibrium expected(.7855);
    for (int n = 13; n >= 4; --n) {
        const auto k = static_cast<std::size_t>(n);
        forces.expect("force below block " + std::to_string(n), "kN", slope.force[k] / 1e3,
                      expected.force[k] / 1e3, relative(.05));
    }
}

// V21. The friction at the limit, and the forces between the toppling blocks there, for any penalty. Locked
// augmented contacts may move by the tolerance in each of 12 000 steps. With 1e-7 m, a millimetre in total,
// the slope with springs of 1 E would creep to forces 10 to 40 % wrong; 1e-9 m is small enough.
TEST(LongToppling, FailsAtTheSameFrictionForAnyPenalty) {
    const double critical = critical_friction();
    double found = 0;
    for (const ContactSetting& setting : {ContactSetting{1}, ContactSetting{100}}) {
        Slope slope(0, setting);
        const std::string set_up = "sixteen blocks, " + setting.name();
        found = threshold(critical - 1, critical + 1, 4, [&](double phi) { return slope.holds(phi); });
        Case limit("V21", set_up, "required; found by halving to 0.13°");
        limit.contact_frequency_step(slope.frequency_step);
        limit.expect("φ at the limit", "°", found, critical, absolute(1));
        expect_forces_of_the_table(slope, set_up + ", 0.1° above the limit found", found + .1);
    }
    for (const ContactSetting& setting : {ContactSetting{1, 1e-9}, ContactSetting{100, 1e-9}}) {
        Slope slope(0, setting);
        expect_forces_of_the_table(slope, "sixteen blocks, " + setting.name() + ", at the friction of 100 E",
                                   found + .1);
    }
}

class PushedToppling : public testing::TestWithParam<std::pair<double, double>> {};

// P05. The recursion of V21 with the weight inclined by atan k. The acceleration grows within a second at the
// friction of the test: a static limit says nothing of a slope that is released at once. Above the limit
// blocks come to rest within the three seconds that follow, after up to a decimetre; below it they are faster
// than 0.1 m/s by then. Steps of 1 ms suffice for that.
TEST_P(PushedToppling, FailsAtTheFrictionOfLimitEquilibrium) {
    const auto [k, expected] = GetParam();
    const double critical = critical_friction(k);
    EXPECT_NEAR(critical, expected, 5e-3);
    Slope slope(0, {.5}, k);
    std::optional<EnergyMonitor> energy;  // of the last run that failed
    const auto rests = [&](double phi) {
        slope.run(phi, 4, 1e-3);
        if (slope.speed >= .03) energy = slope.energy;
        return slope.speed < .03;
    };
    ASSERT_FALSE(rests(critical - .7));
    ASSERT_TRUE(rests(critical + .7));
    const double found = threshold(critical - .7, critical + .7, 3, rests);
    const std::string set_up = "k = " + to_text(k);
    expect_energy_balance("P05", set_up, *energy, slope.frequency_step);
    Case limit("P05", set_up, "required; found by halving to 0.18°");
    limit.contact_frequency_step(slope.frequency_step);
    limit.expect("φ at the limit", "°", found, critical, absolute(.7));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, PushedToppling,
                         testing::Values(std::pair(0., 38.15), std::pair(.05, 39.925), std::pair(.1, 41.381),
                                         std::pair(.15, 42.619)),
                         [](const auto& p) { return case_name("k_" + case_number(p.param.first)); });

// V21. At tan(phi) = 0.65 the slope needs support. Block 1 slides. A horizontal bolt in it has the tension T
// given by T (cos psi + mu sin psi) = P (1 - mu^2) + W (sin psi - mu cos psi), with P the force from block 2
// at full friction.
TEST(LongToppling, IsHeldByTheBoltOfGoodmanAndBray) {
    const double mu = .65;
    const double psi = radians(dip);
    const LimitEquilibrium limit(mu);
    const double expected =
        (limit.force[2] * (1 - mu * mu) + weight * width * height(1) * (std::sin(psi) - mu * std::cos(psi))) /
        (std::cos(psi) + mu * std::sin(psi));
    EXPECT_NEAR(expected, 2013e3, 1e3);
    const double phi = std::atan(mu) * 180 / std::numbers::pi;
    double frequency_step = 0;
    std::optional<EnergyMonitor> energy;
    const auto holds = [&](double share) {
        Slope slope(share * expected);
        const bool held = slope.stops(phi);
        frequency_step = slope.frequency_step;
        energy = slope.energy;
        return held;
    };
    ASSERT_FALSE(holds(.9));
    ASSERT_TRUE(holds(1.1));
    const double found = threshold(.9, 1.1, 3, holds) * expected;
    Case bolt("V21", "horizontal bolt in block 1, tan φ = 0.65",
              "required of the table; found by halving to 2.5 %");
    bolt.contact_frequency_step(frequency_step);
    expect_energy_balance("V21", "horizontal bolt in block 1, tan φ = 0.65", *energy, frequency_step);
    bolt.expect("tension at the limit", "kN", found / 1e3, expected / 1e3, relative(.05));
}

}  // namespace
}  // namespace rockslope::toppling_test
