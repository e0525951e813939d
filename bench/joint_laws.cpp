// Times the joint laws of a contact: the strength, evaluated in each iteration, and the advance of the
// history, once per step. Each law is timed for a compressed contact at rest, locked with a displacement, and
// sliding.

#include <benchmark/benchmark.h>

#include "dda/joint/barton_bandis.hpp"
#include "dda/joint/shear_step.hpp"
#include "support/cyclic_joints.hpp"

using namespace rockslope;

namespace {

using dda::JointLaw;
using dda::JointLoad;
using dda::ShearedJoint;

constexpr JointLoad load{1e5, 0.1, 1.5e8};

struct Situation {
    const char* name;
    double displacement;  ///< shear displacement of the step, m
};
constexpr Situation situations[] = {{"rest", 0}, {"locked", -1e-6}, {"sliding", 1e-5}};

struct Candidate {
    const char* name;
    JointLaw law;
};

/// The joint laws; the cyclic ones are in their second cycle, so that tables and wear are in use.
std::vector<Candidate> candidates() {
    dda::MohrCoulomb smooth;
    smooth.friction_angle = smooth.residual_friction_angle = 0.6;
    dda::CyclicBartonBandis wearing = joint_tests::granite();
    wearing.reversal_factor = 0.9;
    wearing.further_cycle_factor = 0.9;
    return {
        {"mohr-coulomb", smooth},
        {"barton-bandis",
         dda::BartonBandis{joint_tests::granite_strength(), 1.25e-3, dda::barton_1985(), true, 1}},
        {"cyclic-barton-bandis", joint_tests::granite()},
        {"cyclic-barton-bandis, wearing", wearing},
        {"weakening", dda::Weakening{0.6, 0.4, 1e5, 0, 5e-3, true}},
        {"plesha", dda::Plesha{0.6, 0.2, 1e-4}},
    };
}

/// The joint after one cycle, sliding forward again.
ShearedJoint worn(const JointLaw& law) {
    ShearedJoint joint{dda::fresh_history(law, true)};
    for (const double displacement : {5e-3, -8e-3, 6e-3}) joint = dda::shear(law, joint, displacement, load);
    return joint;
}

void time_strength(benchmark::State& state, const JointLaw& law, double displacement) {
    const ShearedJoint joint = worn(law);
    double normal = load.normal_force;
    for (auto _ : state) {
        benchmark::DoNotOptimize(normal);
        benchmark::DoNotOptimize(
            dda::strength(law, joint.history, normal, load.length,
                          dda::ShearTrial{displacement, joint.shear_force, load.stiffness}));
    }
}

void time_advance(benchmark::State& state, const JointLaw& law, double displacement) {
    const ShearedJoint joint = worn(law);
    const double slip = displacement > 0 ? displacement : 0;
    const dda::ContactMotion motion{slip,  displacement,      load.normal_force, load.length,
                                    false, joint.shear_force, load.stiffness};
    for (auto _ : state) benchmark::DoNotOptimize(dda::advance(law, joint.history, motion));
}

}  // namespace

int main(int argc, char** argv) {
    for (const Candidate& candidate : candidates()) {
        for (const Situation& at : situations) {
            const std::string name = std::string(candidate.name) + "/" + at.name;
            benchmark::RegisterBenchmark(("strength/" + name).c_str(), time_strength, candidate.law,
                                         at.displacement);
            benchmark::RegisterBenchmark(("advance/" + name).c_str(), time_advance, candidate.law,
                                         at.displacement);
        }
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
