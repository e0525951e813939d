// Waves that leave a model through dashpots, enter through dashpots, and cross a joint.

#include <gtest/gtest.h>

#include <complex>

#include "support/bar.hpp"
#include "support/energy_balance.hpp"
#include "support/record.hpp"

namespace rockslope::viscous_boundary_test {
namespace {

using namespace scene;
using namespace verification;

constexpr double speed = 2000;              // m/s, of the bar in plane stress
constexpr double impedance = 2500 * speed;  // Pa s/m

/// Closes an end of the bar with dashpots.
void add_viscous_end(Bar& bar, bool left, double normal_impedance, const std::string& name = "end") {
    // Edge 1 of a box is its right side and edge 3 its left.
    const int edge = left ? 3 : 4 * (bar.count - 1) + 1;
    bar.s.model.viscous_boundaries.push_back({name, {{edge, 0, 1}}, normal_impedance, 0, dda::Hold::both});
}

/// The velocity pulse reflected at the end of a bar over the incident one, with its sign.
struct Returned {
    double coefficient = 0;
    double contact_frequency_step = 0;
};
Returned reflected(const std::string& set_up, double end_impedance) {
    Bar bar(100, 0.1, dda::Plane::stress);
    add_viscous_end(bar, false, end_impedance);
    bar.push({1e6, 0}, raised_cosine(1e-3));
    Simulation sim(bar.s);
    const Seismogram record(sim, {49}, 0);
    EXPECT_EQ(sim.run(wave_stage(9e-3, 2e-5)).status, dda::RunStatus::completed);
    double incident = 0;
    double back = 0;
    for (std::size_t k = 0; k < record.times.size(); ++k) {
        // The pulse passes the middle at 2.5 to 3.5 ms, and again at 7.5 to 8.5 ms.
        const double v = record.values[0][k];
        double& largest = record.times[k] < 5.5e-3 ? incident : back;
        if (std::abs(v) > std::abs(largest)) largest = v;
    }
    const dda::Energy& e = sim.state.energy;
    expect_energy_balance("V32", set_up, sim);
    const double coefficient = back / incident;
    // The dashpots dissipate the energy that is not reflected.
    EXPECT_NEAR(e.boundary_loss / e.external_work, 1 - coefficient * coefficient, 0.02);
    return {coefficient, sim.contact_frequency_step()};
}

// V32. Dashpots with the impedance of the bar absorb the pulse. Others reflect (Zb - Z)/(Zb + Z) of its
// stress, and the same fraction of its velocity with the opposite sign. Within 3 % of the incident pulse.
TEST(ViscousBoundary, AbsorbsWavesOfItsOwnImpedance) {
    const std::string set_up = "dashpots of the bar's impedance";
    const Returned r = reflected(set_up, impedance);
    Case("V32", set_up, "required")
        .contact_frequency_step(r.contact_frequency_step)
        .expect_below("reflected over incident", "1", r.coefficient, 0.03);
}
TEST(ViscousBoundary, ReflectsByTheMismatchOfImpedance) {
    for (const double ratio : {0.25, 0.5, 2.0, 4.0}) {
        const double expected = (ratio - 1) / (ratio + 1);
        const std::string set_up = "dashpots of " + to_text(ratio) + " times the bar's";
        const Returned r = reflected(set_up, ratio * impedance);
        // The reflected velocity has the opposite sign of the reflected stress.
        Case("V32", set_up, "required")
            .contact_frequency_step(r.contact_frequency_step)
            .expect("R", "1", -r.coefficient, expected, absolute(0.03));
    }
}

/// A bar with viscous boundaries at both ends. A pulse enters at the left; the middle joint may be soft.
struct EndlessBar {
    static constexpr int count = 60;
    std::vector<double> times;
    std::vector<double> before;  ///< velocity left of the middle joint, m/s
    std::vector<double> behind;
    double contact_frequency_step = 0;

    EndlessBar(const std::string& id, const std::string& set_up, double middle_stiffness) {
        Bar bar(count, 1, dda::Plane::stress);
        add_viscous_end(bar, true, impedance, "left");
        add_viscous_end(bar, false, impedance, "right");
        if (middle_stiffness > 0) {
            bar.s.model.joint_materials.push_back(elastic_joint(middle_stiffness, middle_stiffness));
            const auto mark = [&](int edge) { bar.s.model.topology.joint_material[edge] = 1; };
            mark(4 * (count / 2 - 1) + 1);
            mark(4 * (count / 2) + 3);
        }
        Simulation sim(bar.s);
        const Seismogram record(sim, {9, count - 10}, 0);
        dda::Stage stage = wave_stage(0.12, 1e-4);
        stage.incident_waves.push_back({"left", raised_cosine(0.01), dda::TimeTable({0, 1}, {0, 0})});
        EXPECT_EQ(sim.run(stage).status, dda::RunStatus::completed);
        times = record.times;
        before = record.values[0];
        behind = record.values[1];
        contact_frequency_step = sim.contact_frequency_step();
        expect_energy_balance(id, set_up, sim);
    }
};

/// Magnitude of the Fourier transform of a velocity. @param frequency Hz
double spectrum(const std::vector<double>& times, const std::vector<double>& values, double frequency) {
    std::complex<double> sum = 0;
    for (std::size_t k = 0; k < times.size(); ++k)
        sum += values[k] * std::polar(1.0, -2 * std::numbers::pi * frequency * times[k]);
    return std::abs(sum);
}

// The wave that enters through a boundary has the prescribed velocity, not twice or half of it.
TEST(ViscousBoundary, TransmitsTheIncidentWave) {
    const std::string set_up = "incident wave of 1 m/s through dashpots";
    const EndlessBar bar("V32", set_up, 0);
    double largest = 0;
    for (const double v : bar.behind) largest = std::max(largest, v);
    Case("V32", set_up, "dispersion of a pulse of 20 blocks")
        .contact_frequency_step(bar.contact_frequency_step)
        .expect("velocity that arrives", "m/s", largest, 1, relative(0.01));
}

// V33, Eq. (46). A linear joint of stiffness k transmits T = 1/sqrt(1 + (z w/2k)^2) of a wave and reflects R
// = sqrt(1 - T^2): both 0.7071 at 50 Hz for k = z w/2 = 7.854e8 Pa/m. The spectra of one pulse give all
// frequencies. They are divided by those of a bar without the joint, so that dispersion cancels.
TEST(LinearJoint, TransmitsAndReflectsByItsStiffness) {
    const double k = impedance * 2 * std::numbers::pi * 50 / 2;
    EXPECT_NEAR(k, 7.854e8, 1e5);
    const EndlessBar whole("V33", "one pulse, no joint", 0);
    const EndlessBar jointed("V33", "one pulse, k = 7.854e8 Pa/m", k);
    std::vector<double> back = jointed.before;
    for (std::size_t i = 0; i < back.size(); ++i) back[i] -= whole.before[i];
    for (const double frequency : {25.0, 50.0, 75.0}) {
        const double transmission = 1 / std::hypot(1, frequency / 50);
        const double reflection = std::sqrt(1 - transmission * transmission);
        const double t = spectrum(jointed.times, jointed.behind, frequency) /
                         spectrum(whole.times, whole.behind, frequency);
        const double r =
            spectrum(jointed.times, back, frequency) / spectrum(whole.times, whole.before, frequency);
        char set_up[80];
        std::snprintf(set_up, sizeof set_up, "%g Hz, k = 7.854e8 Pa/m", frequency);
        const Case row = Case("V33", set_up, "waves of 27 to 80 blocks")
                             .contact_frequency_step(jointed.contact_frequency_step);
        row.expect("T", "1", t, transmission, relative(0.01));
        row.expect("R", "1", r, reflection, relative(0.01));
    }
    Curve curves[] = {{"1/sqrt(1 + (z ω/2k)²)", {}, {}}, {"engine", {}, {}}, {"engine", {}, {}}};
    for (double frequency = 5; frequency <= 100; frequency += 2.5) {
        for (Curve& curve : curves) curve.x.push_back(frequency);
        curves[0].y.push_back(1 / std::hypot(1, frequency / 50));
        curves[1].y.push_back(spectrum(jointed.times, jointed.behind, frequency) /
                              spectrum(whole.times, whole.behind, frequency));
        curves[2].y.push_back(spectrum(jointed.times, back, frequency) /
                              spectrum(whole.times, whole.before, frequency));
    }
    Curve reflection{"1/sqrt(1 + (2k/z ω)²)", curves[0].x, {}};
    for (const double t : curves[0].y) reflection.y.push_back(std::sqrt(1 - t * t));
    const std::string joint = " one joint of k = 7.854e8 Pa/m";
    record_picture("V33", "transmission", "V33: passing" + joint, "frequency, Hz", "T",
                   {curves[0], curves[1]});
    record_picture("V33", "reflection", "V33: coming back from" + joint, "frequency, Hz", "R",
                   {reflection, curves[2]});
}

// V33. The reflection of a stiff joint, R = x/sqrt(1 + x^2) with x = z w/2k, is first-order in its compliance
// 1/k: from x = 1/8 to 1/32 the order of the formula is 0.994. The loss of transmission, 1 - T, is
// second-order.
TEST(LinearJoint, ReflectsToFirstOrderInItsCompliance) {
    const double unit = impedance * 2 * std::numbers::pi * 50 / 2;
    const EndlessBar whole("V33", "one pulse, no joint, for the order", 0);
    const double incident = spectrum(whole.times, whole.before, 50);
    std::vector<double> reflected_share;
    std::vector<double> x = {1. / 8, 1. / 16, 1. / 32};
    double frequency_step = 0;
    for (const double give : x) {
        const EndlessBar jointed("V33", "one pulse, z ω/2k = " + to_text(give), unit / give);
        std::vector<double> back = jointed.before;
        for (std::size_t i = 0; i < back.size(); ++i) back[i] -= whole.before[i];
        reflected_share.push_back(spectrum(jointed.times, back, 50) / incident);
        frequency_step = jointed.contact_frequency_step;
    }
    const double formula = std::log2(x[0] / std::hypot(1, x[0]) / (x[2] / std::hypot(1, x[2]))) / 2;
    Case("V33", "50 Hz, z ω/2k = 1/8 to 1/32",
         "waves of 40 blocks; the formula's own order, not its limit of 1")
        .contact_frequency_step(frequency_step)
        .expect("order of R in 1/k", "", std::log2(reflected_share[0] / reflected_share[2]) / 2, formula,
                absolute(.01));
}

}  // namespace
}  // namespace rockslope::viscous_boundary_test
