// Arches of wedge-shaped stones: the tilt that brings one down, the least thickness and friction of another,
// the least thrust. The references are limit states of rigid stones without tension, computed here from
// statics.

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"
#include "support/threshold.hpp"

namespace rockslope::voussoir_test {
namespace {

using namespace scene;
using namespace verification;

/// Voussoirs with corners on two circles about the origin, between fixed skewbacks.
struct Arch {
    double radius;     ///< m, of the centre line
    double thickness;  ///< m
    double embrace;    ///< rad
    int count;         ///< of voussoirs

    /// Joint k = 0 ... count, from the right springing; side -1 inside, +1 outside.
    Vec2 corner(int joint, int side) const {
        const double angle = (std::numbers::pi - embrace) / 2 + embrace * joint / count;
        return (radius + side * thickness / 2) * Vec2(std::cos(angle), std::sin(angle));
    }
    std::vector<Vec2> ring(int k) const {
        return {corner(k, -1), corner(k, 1), corner(k + 1, 1), corner(k + 1, -1)};
    }
};

struct Weight {
    double area = 0;
    Vec2 centroid{0, 0};
};

Weight weight_of(const std::vector<Vec2>& ring) {
    Weight w;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2& a = ring[k];
        const Vec2& b = ring[(k + 1) % ring.size()];
        const double part = dda::cross(a, b) / 2;
        w.area += part;
        w.centroid += part * (a + b) / 3;
    }
    w.centroid /= w.area;
    return w;
}

/// Linear inequalities between four unknowns: row . unknowns >= bound.
struct Inequalities {
    using Row = Eigen::Vector4d;
    std::vector<Row> rows;
    std::vector<double> bounds;

    void require(const Row& row, double at_least) {
        rows.push_back(row / row.norm());
        bounds.push_back(at_least / row.norm());
    }

    bool hold_at(const Row& unknowns, double tolerance) const {
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (rows[k].dot(unknowns) < bounds[k] - tolerance) return false;
        return true;
    }

    /// Where four of them are equations; none if these depend on each other.
    std::optional<Row> corner(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
        Eigen::Matrix4d m;
        m << rows[a].transpose(), rows[b].transpose(), rows[c].transpose(), rows[d].transpose();
        bool invertible = false;
        Eigen::Matrix4d inverse;
        m.computeInverseWithCheck(inverse, invertible, 1e-10);
        if (!invertible) return std::nullopt;
        return inverse * Row(bounds[a], bounds[b], bounds[c], bounds[d]);
    }
};

/// The conditions of an arch of rigid stones in equilibrium without tension and within the friction `mu`.
/// Unknowns: the force (X, Y) and the moment about the origin that the right skewback exerts, and the
/// horizontal acceleration over gravity. Every joint gives four inequalities: the force crosses it between
/// its two corners and within the friction.
Inequalities equilibrium_of(const Arch& arch, double mu) {
    using Row = Inequalities::Row;
    Inequalities conditions;
    double area = 0;
    Vec2 moment(0, 0);  // of the areas
    for (int k = 0; k <= arch.count; ++k) {
        const Vec2 out = arch.corner(k, 1);
        const Vec2 along = (out - arch.corner(k, -1)).normalized();
        const Vec2 normal = dda::perpendicular(along);  // to the following stone
        // The force through the joint on the following stone is (X + lambda A, Y - A), its moment about the
        // origin M - lambda moment_y - moment_x, with the area A and its moments of the stones before.
        const Row force_x(1, 0, 0, area);
        const Row force_y(0, 1, 0, 0);
        const auto about = [&](const Vec2& p) {
            // M - (p x F) as a row, and the constant part of it on the other side.
            const Row row = Row(0, 0, 1, -moment.y()) - p.x() * force_y + p.y() * force_x;
            return std::pair(row, moment.x() - p.x() * area);
        };
        // Compression between the corners: it turns stones inwards about the outer corner and outwards about
        // the inner one.
        const auto [outer, outer_bound] = about(out);
        conditions.require(-outer, -outer_bound);
        const auto [inner, inner_bound] = about(arch.corner(k, -1));
        conditions.require(inner, inner_bound);
        for (const double sign : {1., -1.}) {
            const Vec2 direction = mu * normal + sign * along;
            conditions.require(direction.x() * force_x + direction.y() * force_y, direction.y() * area);
        }
        if (k == arch.count) break;
        const Weight stone = weight_of(arch.ring(k));
        area += stone.area;
        moment += stone.area * stone.centroid;
    }
    return conditions;
}

/// The largest horizontal acceleration, over gravity, under which an arch of rigid stones is in equilibrium
/// without tension and within the friction `mu`; none if there is no such equilibrium at all. By the static
/// theorem an arch whose stones do not slip stands up to this acceleration. The maximum lies where four of
/// the conditions are equations; all foursomes are tried.
std::optional<double> largest_acceleration(const Arch& arch, double mu) {
    const Inequalities conditions = equilibrium_of(arch, mu);
    std::optional<double> largest;
    const std::size_t n = conditions.rows.size();
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = a + 1; b < n; ++b) {
            for (std::size_t c = b + 1; c < n; ++c) {
                for (std::size_t d = c + 1; d < n; ++d) {
                    const auto x = conditions.corner(a, b, c, d);
                    if (x && (!largest || (*x)[3] > *largest) && conditions.hold_at(*x, 1e-9 * arch.radius))
                        largest = (*x)[3];
                }
            }
        }
    }
    return largest;
}

/// An arch in the engine. Rock and springs are a hundred times stiffer than the catalogue's, because the
/// stones of a limit state are rigid.
struct Engine {
    static Scene scene(const Arch& arch, double mu) {
        Scene s;
        s.friction(std::atan(mu) * 180 / std::numbers::pi);
        s.model.block_materials[0].youngs_modulus = 1e12;
        s.model.normal_penalty = s.model.shear_penalty = 1e12;
        const auto skewback = [&](int joint, double behind) {
            const Vec2 inner = arch.corner(joint, -1), outer = arch.corner(joint, 1);
            const Vec2 along = (outer - inner).normalized();
            const Vec2 back = behind * dda::perpendicular(along);
            const Vec2 a = inner - .5 * along, b = outer + .5 * along;
            return behind < 0 ? std::vector<Vec2>{a, a + back, b + back, b}
                              : std::vector<Vec2>{a, b, b + back, a + back};
        };
        s.block({skewback(0, -1)}, dda::Motion::prescribed, "right");
        s.block({skewback(arch.count, 1)}, dda::Motion::fixed);
        for (int k = 0; k < arch.count; ++k) s.block({arch.ring(k)});
        return s;
    }
    /// The arch under its weight, with friction that does not slip. An arch that falls is left as it is after
    /// 100 steps.
    static dda::State settled(const Arch& arch) {
        Simulation sim(scene(arch, 10));
        dda::Stage stage;
        stage.kind = dda::StageKind::static_equilibrium;
        stage.tolerance = 1e-7;
        stage.step_limit = 100;
        sim.run(stage);
        return sim.state;
    }
    /// Whether the arch stands for `duration`, s, while a horizontal acceleration grows to `lambda` g in half
    /// a second and stays. Stones of an arch that stands move by less than a thousandth of its thickness.
    bool stands(const Arch& arch, double mu, double lambda, double duration) {
        Scene s = scene(arch, mu);
        s.model.loads.push_back(
            dda::BodyLoad{dda::BlockIndex::none(), {lambda * g, 0}, dda::TimeTable({0, .5, 100}, {0, 1, 1})});
        Simulation sim(s);
        sim.state = settled(arch);
        sim.restart_ledger();
        EXPECT_EQ(sim.shake(duration, 2e-3).status, dda::RunStatus::completed);
        double moved = 0;
        for (int b = 2; b < arch.count + 2; ++b) moved = std::max(moved, sim.moved(b).norm());
        const bool stood = moved < 1e-3 * arch.thickness;
        if (!stood) {
            frequency_step = sim.contact_frequency_step();
            energy = sim.energy;
        }
        return stood;
    }
    double frequency_step = 0;            ///< of the last run in which the arch fell
    std::optional<EnergyMonitor> energy;  ///< of the same run; where nothing moves the balance is rounding
};

const std::string halved = "required; found by halving to 0.5 %";

// P02. Four hinges on alternating sides turn an arch of seven straight stones into a mechanism. The
// acceleration is the largest with a line of thrust inside the stones. At 75 degrees no joint slips. 4 % to
// either side is halved four times.
TEST(TiltedArch, FallsAtTheAccelerationOfFourHinges) {
    const Arch arch{10, 1.5, radians(157.5), 7};
    const double mu = std::tan(radians(75));
    const std::optional<double> expected = largest_acceleration(arch, mu);
    ASSERT_TRUE(expected);
    EXPECT_NEAR(*expected, .37361, 1e-5);
    Engine engine;
    const double found =
        threshold(1.04, .96, 4, [&](double share) { return engine.stands(arch, mu, share * *expected, 2); });
    const std::string set_up = "radius 10 m, 1.5 m thick, 157.5°, seven stones";
    Case tilted("P02", set_up, halved);
    tilted.contact_frequency_step(engine.frequency_step);
    tilted.expect("horizontal acceleration that brings it down, over g", "", found * *expected, *expected,
                  relative(.02));
    expect_energy_balance("P02", set_up, *engine.energy, engine.frequency_step);
}

Arch semicircle(double thickness_over_radius, int stones = 12) {
    return {10, 10 * thickness_over_radius, std::numbers::pi, stones};
}

/// Finds the least value at which the arch stands, by halving. `stands(engine, value)` tries one.
template <class Stands>
void expect_least(const char* quantity, double expected, const std::string& set_up, const Stands& stands) {
    Engine engine;
    const double found =
        threshold(.96, 1.04, 4, [&](double share) { return stands(engine, share * expected); });
    Case least("P03", set_up, halved);
    least.contact_frequency_step(engine.frequency_step);
    least.expect(quantity, "", found * expected, expected, relative(.02));
    expect_energy_balance("P03", set_up, *engine.energy, engine.frequency_step);
}

// P03. A symmetric arch is in equilibrium under a horizontal acceleration to the right if it is under one to
// the left, and the states of equilibrium are a convex set. So the least thickness and friction are those at
// which the largest acceleration is 0 and below which there is no equilibrium.
TEST(LeastArch, StandsFromTheThicknessOfTheThrustLine) {
    constexpr double expected = .10486;
    EXPECT_FALSE(largest_acceleration(semicircle(expected - 2e-5), 10));
    EXPECT_TRUE(largest_acceleration(semicircle(expected + 2e-5), 10));
    expect_least("least t/R", expected, "semicircle of twelve stones, no slip",
                 [](Engine& engine, double value) { return engine.stands(semicircle(value), 10, 0, 3); });
}

TEST(LeastArch, StandsFromTheFrictionOfTheThrustLine) {
    constexpr double expected = .38278;
    EXPECT_FALSE(largest_acceleration(semicircle(.12), expected - 1e-4));
    EXPECT_TRUE(largest_acceleration(semicircle(.12), expected + 1e-4));
    expect_least("least friction coefficient", expected, "semicircle of twelve stones, t/R = 0.12",
                 [](Engine& engine, double value) { return engine.stands(semicircle(.12), value, 0, 3); });
}

// P12. When its abutments spread, the arch opens hinges, outside at the crown and inside at joint k of each
// haunch. The part of weight W_k between them turns about the latter: H (y_crown - y_k) = W_k (x_k - x of its
// centroid). The thrust line of this H touches the inside at that joint and is within the stones at all
// others, so H is the largest of these over k. The abutment moves by 2 mm, a thousandth of the thickness, in
// a second; settling removes what still moves.
TEST(SpreadArch, HasHeymansLeastThrust) {
    const Arch arch = semicircle(.15, 16);
    const int crown = arch.count / 2;
    double expected = 0;
    double weight = 0;
    double moment = 0;
    for (int k = crown - 1; k >= 0; --k) {
        const Weight stone = weight_of(arch.ring(k));
        weight += 2500 * g * stone.area;
        moment += 2500 * g * stone.area * stone.centroid.x();
        const Vec2 hinge = arch.corner(k, -1);
        expected =
            std::max(expected, (weight * hinge.x() - moment) / (arch.corner(crown, 1).y() - hinge.y()));
    }
    Simulation sim(Engine::scene(arch, 10));
    ASSERT_EQ(sim.settle(.005, 1e-7).status, dda::RunStatus::completed);
    dda::Stage spread;
    spread.duration = 1.5;
    spread.control.step = 2e-3;
    const double a = 4 * 2e-3;
    spread.base_motions.push_back(
        {"right", dda::TimeTable({0, .5, .501, 1, 1.001, 2}, {a, a, -a, -a, 0, 0}), {}});
    ASSERT_EQ(sim.run(spread).status, dda::RunStatus::completed);
    const std::string set_up = "t/R = 0.15, sixteen stones, abutment moved by 2 mm";
    expect_energy_balance("P12", set_up, sim);
    const double moved = sim.moved(0).x();
    ASSERT_EQ(sim.settle(.005, 1e-7).status, dda::RunStatus::completed);
    Vec2 thrust(0, 0);
    for (const dda::Contact& c : sim.state.contacts.contacts) {
        const Vec2 on_corner = c.normal_force * c.normal - c.shear_force * c.tangent;
        if (c.corner_block == 1) thrust += on_corner;
        if (c.edge_block == 1) thrust -= on_corner;
    }
    Case heyman("P12", set_up, "required; the hinges' arms change by 2 mm in 4 m");
    heyman.contact_frequency_step(sim.contact_frequency_step());
    heyman.expect("opening of the abutments", "m", moved, 2e-3, relative(.01));
    heyman.expect("thrust", "N", std::abs(thrust.x()), expected, relative(.01));
}

}  // namespace
}  // namespace rockslope::voussoir_test
