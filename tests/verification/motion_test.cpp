// Free motion and time integration, without contacts.

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "support/case_name.hpp"
#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::motion_test {
namespace {

using namespace scene;
using namespace verification;

// V01. A falling block follows v = -g t, y = -g t^2/2: Newmark (1/2, 1) is exact for constant acceleration,
// so the error is the rounding of about a thousand steps.
TEST(FreeFall, IsExact) {
    Scene s;
    const int block = s.box({0, 0}, 1, 1);
    Simulation sim(s);
    ASSERT_EQ(sim.shake(1, 0.001).status, dda::RunStatus::completed);
    const Case fall("V01", "1 m square, 1 s",
                    "Newmark (1/2, 1) is exact here: rounding of a thousand steps is left");
    fall.expect("y(1 s)", "m", sim.moved(block).y(), -g / 2, absolute(1e-9));
    fall.expect("v(1 s)", "m/s", sim.velocity(block)[1], -g, absolute(1e-9));
    fall.expect_below("stress, of 25 kPa that gravity could make", "Pa", sim.stress(block).norm(), 1e-3);
    fall.expect_below("x(1 s)", "m", sim.moved(block).x(), 1e-12);
    expect_energy_balance("V01", "1 m square, 1 s", sim);
}

// V28. Ten revolutions at 2 pi rad/s, dt = 1 ms. With the exact rotation, area, kinetic energy and stress are
// constant. With a linearised rotation the area would grow by (1 + dtheta^2)^N = 1.484.
TEST(SpinningBlock, NeitherGrowsNorSlows) {
    Scene s;
    s.model.gravity.setZero();
    const int block = s.box({-0.5, -0.5}, 1, 1);
    Simulation sim(s);
    sim.velocity(block)[2] = 2 * std::numbers::pi;
    sim.restart_ledger();
    dda::Stage stage;
    stage.name = "spin";
    stage.duration = 10;
    stage.control.step = 1e-3;
    stage.control.displacement_ratio = 0.1;
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    const double inertia = 2500.0 / 6;
    const double kinetic = inertia * 2 * std::numbers::pi * std::numbers::pi;
    const std::string set_up = "ten turns at one a second, steps of 1 ms";
    expect_energy_balance("V28", set_up, sim);
    const Case spin("V28", set_up, "required; linearised, the area would be 1.484");
    spin.expect("area", "m²", sim.state.blocks.moments[0].area, 1, absolute(1e-6));
    spin.expect("kinetic energy", "J/m", sim.state.energy.kinetic, kinetic, relative(1e-6));
    spin.expect("angle", "rad", sim.state.blocks.rotation[0], 20 * std::numbers::pi, absolute(1e-6));
    spin.expect_below("a corner's way from its start", "m",
                      (sim.state.blocks.vertices[0] - Vec2(-0.5, -0.5)).norm(), 1e-6);
}

/// Amplification matrix of Newmark (1/2, 1) for an oscillator of angular frequency w, Eq. (17):
/// x1 = tr x0 - det x(-1), from the exact 2x2 matrix.
struct Amplification {
    double trace, determinant;
    explicit Amplification(double w_dt)
        : trace((4 - w_dt * w_dt) / (2 + w_dt * w_dt)), determinant(2 / (2 + w_dt * w_dt)) {}
    double angle() const { return std::acos(trace / (2 * std::sqrt(determinant))); }
    double amplitude_per_cycle() const { return std::pow(determinant, std::numbers::pi / angle()); }
};

/// Draws the positions of an oscillator with the envelope and the frequency of the amplification matrix.
void draw_decay(const std::vector<double>& x, const Amplification& exact, double frequency, double dt) {
    Curve engine{"engine", {}, {}};
    for (std::size_t k = 0; k < x.size(); ++k) {
        engine.x.push_back(frequency * dt * static_cast<double>(k));
        engine.y.push_back(x[k] * 1e6);
    }
    Curve matrix{"amplification matrix", {}, {}};
    const double scale =
        x[1] * 1e6 / (std::sqrt(exact.determinant) * std::sin(exact.angle()));  // through the first two
    for (int k = 0; k <= 400; ++k) {
        const double steps = static_cast<double>(x.size() - 1) * k / 400;
        matrix.x.push_back(frequency * dt * steps);
        matrix.y.push_back(scale * std::pow(exact.determinant, steps / 2) * std::sin(exact.angle() * steps));
    }
    record_picture("V27", "decay", "V27: oscillator in steps of ω Δt = 0.2", "ω t", "displacement, µm",
                   {matrix, engine});
}

struct OscillatorCase {
    double w_dt, amplitude, period_ratio;
};

class Oscillator : public testing::TestWithParam<OscillatorCase> {};

// V27. A block on a fixed-point spring is a single oscillator, damped only by the integration. The recurrence
// of its positions gives decay and period without fitting, so the tolerance covers only the rounding of the
// table.
TEST_P(Oscillator, DecaysByTheAmplificationMatrix) {
    const auto [w_dt, amplitude, period_ratio] = GetParam();
    Scene s;
    s.model.gravity.setZero();
    const int block = s.box({-0.5, -0.5}, 1, 1);
    s.model.fixed_points.push_back({s.material_point(block, {0, 0}), true, true});
    const double frequency = 10;
    s.model.fixed_point_penalty = 2500 * frequency * frequency;
    Simulation sim(s);
    sim.velocity(block)[0] = 1e-4;
    sim.restart_ledger();
    std::vector<double> x = {0};
    sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
        x.push_back(state.blocks.moments[0].centroid.x());
    };
    const double dt = w_dt / frequency;
    ASSERT_EQ(sim.shake((w_dt == .2 ? 100 : 20) * dt, dt).status, dda::RunStatus::completed);
    // Least squares for (trace, -determinant) over all triples.
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Vec2 right = Vec2::Zero();
    for (std::size_t k = 2; k < x.size(); ++k) {
        const Vec2 row(x[k - 1], x[k - 2]);
        normal += row * row.transpose();
        right += x[k] * row;
    }
    const double det = normal.determinant();
    const double trace = (right[0] * normal(1, 1) - right[1] * normal(0, 1)) / det;
    const double determinant = -(right[1] * normal(0, 0) - right[0] * normal(0, 1)) / det;
    const Amplification exact(w_dt);
    if (w_dt == .2) draw_decay(x, exact, frequency, dt);
    const std::string set_up = "ω Δt = " + to_text(w_dt);
    expect_energy_balance("V27", set_up, sim);
    const Case matrix("V27", set_up, "the recurrence of the positions is exact: rounding is left");
    matrix.expect("trace", "", trace, exact.trace, absolute(1e-8));
    matrix.expect("determinant", "", determinant, exact.determinant, absolute(1e-8));
    const double angle = std::acos(trace / (2 * std::sqrt(determinant)));
    const Case table("V27", set_up, "required; covers the rounding of the table");
    table.expect("amplitude kept in a cycle", "", std::pow(determinant, std::numbers::pi / angle), amplitude,
                 absolute(1e-3));
    table.expect("period over the true one", "", w_dt / angle, period_ratio, absolute(1e-3));
}

INSTANTIATE_TEST_SUITE_P(
    Catalogue, Oscillator,
    testing::Values(OscillatorCase{0.05, .92449, 1.0003}, OscillatorCase{0.1, .85482, 1.0011},
                    OscillatorCase{0.2, .73163, 1.0046}, OscillatorCase{0.5, .46753, 1.0273},
                    OscillatorCase{1.0, .24731, 1.0968}),
    [](const auto& tested) { return case_name("w_dt " + case_number(tested.param.w_dt)); });

/// Position at t = 1 s under a unit acceleration sin(w t) or cos(w t), less the exact one.
/// @param track receives the position at every step, if not null.
double driven_error(const std::string& id, bool cosine, double w, double dt, Curve* track = nullptr) {
    Scene s;
    s.model.gravity.setZero();
    const int block = s.box({-0.5, -0.5}, 1, 1);
    // The table is so fine that the load is exact at the ends of all steps.
    std::vector<double> times;
    std::vector<double> values;
    for (int k = 0; k <= 2000; ++k) {
        times.push_back(k * 0.0005);
        values.push_back(cosine ? std::cos(w * times.back()) : std::sin(w * times.back()));
    }
    s.model.loads.push_back(
        dda::PointLoad{s.material_point(block, {0, 0}), {2500, 0}, dda::TimeTable(times, values)});
    Simulation sim(s);
    sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
        if (track == nullptr) return;
        track->x.push_back(state.time);
        track->y.push_back(sim.moved(block).x());
    };
    dda::Stage stage;
    stage.name = "drive";
    stage.duration = 1;
    stage.control.step = dt;
    stage.control.displacement_ratio = 1;
    EXPECT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    expect_energy_balance(id, std::string(cosine ? "cosine" : "sine") + " load, Δt = " + to_text(dt) + " s",
                          sim);
    return sim.moved(block).x() - (cosine ? (1 - std::cos(w)) / (w * w) : 1 / w);
}

/// Draws the errors over the step on logarithmic axes, with the leading terms of their series.
void draw_orders(const double (&steps)[3], const double (&sine)[3], const double (&cosine)[3], double w) {
    Curve curves[] = {{"Δt² ω/12", {}, {}}, {"engine", {}, {}}, {"Δt/2", {}, {}}, {"engine", {}, {}}};
    for (int k = 0; k < 3; ++k) {
        const double values[] = {steps[k] * steps[k] * w / 12, std::abs(sine[k]), steps[k] / 2,
                                 std::abs(cosine[k])};
        for (int c = 0; c < 4; ++c) {
            curves[c].x.push_back(std::log10(steps[k]));
            curves[c].y.push_back(std::log10(values[c]));
        }
    }
    const std::string title = "V50: error of x(1 s) against the step, ";
    record_picture("V50", "sine", title + "sine load", "log₁₀ of the step in s", "log₁₀ of the error in m",
                   {curves[0], curves[1]});
    record_picture("V50", "cosine", title + "cosine load", "log₁₀ of the step in s",
                   "log₁₀ of the error in m", {curves[2], curves[3]});
}

// V50. The integration is first-order. The cosine load starts at its peak, and evaluation at the ends of
// steps misses dt/2 of its initial value (error -dt/2 a0). For a load that starts at zero this term vanishes,
// and the error is second-order, -dt^2 w/12 by the Euler-Maclaurin formula.
TEST(IntegratorOrder, IsFirstOrderAndSecondForLoadsThatStartAtZero) {
    const double w = 2 * std::numbers::pi;
    const double sine[] = {driven_error("V50", false, w, 0.01), driven_error("V50", false, w, 0.005),
                           driven_error("V50", false, w, 0.0025)};
    const double cosine[] = {driven_error("V50", true, w, 0.01), driven_error("V50", true, w, 0.005),
                             driven_error("V50", true, w, 0.0025)};
    const double steps[] = {.01, .005, .0025};
    for (const int k : {0, 1}) {
        const Case order("V50", "Δt = " + to_text(steps[k]) + " s halved", "required");
        order.expect("order, sine load", "", std::log2(sine[k] / sine[k + 1]), 2.0, absolute(.1));
        order.expect("order, cosine load", "", std::log2(cosine[k] / cosine[k + 1]), 1.0, absolute(.1));
    }
    draw_orders(steps, sine, cosine, w);
    const double expected_cosine[] = {-5.0e-3, -2.5e-3, -1.25e-3};
    const double expected_sine[] = {5.24e-5, 1.31e-5, 3.27e-6};
    for (const int k : {0, 1, 2}) {
        const Case error("V50", "Δt = " + to_text(steps[k]) + " s",
                         "the next term of the series, and three digits of the table");
        error.expect("error of x(1 s), cosine load", "m", cosine[k], expected_cosine[k], absolute(1e-6));
        error.expect("error of x(1 s), sine load", "m", std::abs(sine[k]), expected_sine[k], relative(.01));
    }
}

// V44. F = 1e4 sin(4 pi t) on 2500 kg: x(1) = 1/pi, v(1) = 0.
TEST(PointLoad, FollowsItsHistory) {
    const double w = 4 * std::numbers::pi;
    Curve engine{"engine", {}, {}};
    const double error = driven_error("V44", false, w, 1e-3, &engine);
    Case("V44", "F = 10 kN sin 4πt on 2500 kg", "required at a step of 1 ms")
        .expect("x(1 s)", "m", 4 * (error + 1 / w), .318310, relative(1e-3));
    Curve closed{"4 (t - sin(ω t)/ω)/ω", engine.x, {}};
    for (double& x : engine.y) x *= 4;
    for (const double t : closed.x) closed.y.push_back(4 * (t - std::sin(w * t) / w) / w);
    record_picture("V44", "position", "V44: 10 kN sin 4πt on 2500 kg", "time, s", "x, m", {closed, engine});
}

}  // namespace
}  // namespace rockslope::motion_test
