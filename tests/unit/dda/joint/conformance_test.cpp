// Properties that every law of the list must have. The laws are taken from the list itself.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "dda/joint/shear_step.hpp"
#include "specimens.hpp"

namespace rockslope::conformance_test {
namespace {

using dda::ContactMotion;
using dda::JointHistory;
using dda::JointLaw;
using dda::JointLoad;
using dda::JointRecord;
using dda::ShearedJoint;
using dda::Strength;

constexpr JointLoad usual{1e5, 0.1, 8e7};
constexpr double forces[] = {-1e12, -10.0, -1e-12, 0.0, 1e-12, 1.0, 10.0, 1e3, 1e5, 1e6, 1e7, 1e12};

/// Displacements of up to a few millimetres in both directions; every fourth step has the full size, the
/// others 1/10, 1/100 and 1/1000 of it.
std::vector<double> random_path(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> size(0, 1);
    std::vector<double> path;
    for (int k = 0; k < 200; ++k) path.push_back(1e-3 * size(random) * std::pow(10.0, -(k % 4)));
    return path;
}

std::vector<ShearedJoint> sheared(const JointLaw& law, const std::vector<double>& path,
                                  const JointLoad& load = usual) {
    ShearedJoint joint{dda::fresh_history(law, true)};
    std::vector<ShearedJoint> states = {joint};
    for (const double displacement : path) {
        joint = dda::shear(law, joint, displacement, load);
        states.push_back(joint);
    }
    return states;
}

void expect_equal(const Strength& a, const Strength& b) {
    EXPECT_EQ(a.forward, b.forward);
    EXPECT_EQ(a.backward, b.backward);
    EXPECT_EQ(a.tensile, b.tensile);
}

/// The tolerance is the rounding of an elastic force of 1e5 N less a strength of 1 N, and the force of a
/// stress of 1 MPa on 1e-15 m.
void expect_ratio(const Strength& a, const Strength& b, double ratio) {
    for (const double Strength::*part : {&Strength::forward, &Strength::backward, &Strength::tensile}) {
        if (std::isinf(b.*part))
            EXPECT_EQ(a.*part, b.*part);
        else
            EXPECT_NEAR(a.*part, ratio * b.*part, 1e-10 * ratio * b.*part + 1e-9);
    }
}

/// Whether the strength drops at the first slip, however small. Then the force at the end of the step with
/// the first slip is the peak, so it depends on the step; the history does not.
bool is_brittle(const JointLaw& law) {
    const auto envelope = dda::coulomb_envelope(law);
    return envelope && dda::bound_line(law, dda::fresh_history(law, true)) != envelope->residual;
}

/// Compares all that a history determines: its record and its strengths. The tolerances are the rounding of a
/// path of some hundred steps and millimetres.
void expect_alike(const JointLaw& law, const ShearedJoint& a, const ShearedJoint& b) {
    const JointRecord ra = dda::record(law, a.history), rb = dda::record(law, b.history);
    EXPECT_EQ(ra.stage, rb.stage);
    EXPECT_EQ(ra.reversals, rb.reversals);
    EXPECT_EQ(ra.cycle, rb.cycle);
    EXPECT_NEAR(ra.mobilised_ratio, rb.mobilised_ratio, 1e-9);
    EXPECT_NEAR(ra.dilation, rb.dilation, 1e-12);
    if (!is_brittle(law)) {
        EXPECT_NEAR(a.shear_force, b.shear_force, 1e-9 * usual.normal_force);
        EXPECT_NEAR(a.slip, b.slip, 1e-12);
    }
    const Strength sa = dda::strength(law, a.history, usual.normal_force, usual.length);
    const Strength sb = dda::strength(law, b.history, usual.normal_force, usual.length);
    if (std::isinf(sa.forward)) return expect_equal(sa, sb);
    EXPECT_NEAR(sa.forward, sb.forward, 1e-9 * usual.normal_force);
    EXPECT_NEAR(sa.backward, sb.backward, 1e-9 * usual.normal_force);
    EXPECT_NEAR(sa.tensile, sb.tensile, 1e-9 * usual.normal_force);
}

bool is_monotonic(const JointLaw& law) {
    return std::visit([](const auto& l) { return joint_tests::strength_grows_with_normal_force(l); }, law);
}

template <class Law>
class JointLawConformance : public testing::Test {
  protected:
    std::vector<JointLaw> laws() const {
        std::vector<JointLaw> all;
        for (const Law& law : joint_tests::specimens<Law>()) all.emplace_back(law);
        return all;
    }
};

TYPED_TEST_SUITE(JointLawConformance, joint_tests::AsTypes<JointLaw>::type, joint_tests::NameOfLaw);

TYPED_TEST(JointLawConformance, StrengthIsNeverNegativeAndGrowsWithTheNormalForce) {
    for (const JointLaw& law : this->laws()) {
        for (const ShearedJoint& joint : sheared(law, random_path(1))) {
            Strength last{};
            for (const double normal : forces) {
                const Strength s = dda::strength(law, joint.history, normal, usual.length);
                EXPECT_GE(s.forward, last.forward) << normal;
                EXPECT_GE(s.backward, last.backward) << normal;
                EXPECT_GE(s.tensile, 0) << normal;
                if (is_monotonic(law)) last = s;
            }
        }
    }
}

TYPED_TEST(JointLawConformance, DegenerateContactsHaveAStrengthToo) {
    for (const JointLaw& law : this->laws()) {
        for (const ShearedJoint& joint : sheared(law, {2e-3, -1e-3})) {
            for (const double length : {0.0, 1e-300, 1e-12, 1.0, 1e12}) {
                for (const double normal : forces) {
                    for (const double displacement : {-1.0, -1e-12, 0.0, 1e-12, 1.0}) {
                        const Strength s =
                            dda::strength(law, joint.history, normal, length, {displacement, 0, 1e8});
                        EXPECT_FALSE(std::isnan(s.forward) || std::isnan(s.backward))
                            << normal << ' ' << length;
                        EXPECT_GE(std::min({s.forward, s.backward, s.tensile}), 0) << normal << ' ' << length;
                        const JointHistory after = dda::advance(
                            law, joint.history, {displacement, displacement, normal, length, false, 0, 1e8});
                        EXPECT_TRUE(std::isfinite(dda::record(law, after).dilation))
                            << normal << ' ' << length;
                    }
                }
            }
        }
    }
}

// Stresses decide, not forces: a joint c times as long under c times the forces, with a spring c times as
// stiff, has c times the strength and dilates as before.
TYPED_TEST(JointLawConformance, ALongerJointUnderTheSameStressIsAsManyTimesAsStrong) {
    for (const JointLaw& law : this->laws()) {
        for (const ShearedJoint& joint : sheared(law, random_path(8))) {
            for (const double c : {1e-3, 0.5, 7.0, 1e3}) {
                for (const double normal : {1.0, 1e4, 1e6}) {
                    const dda::ShearTrial trial{1e-4, joint.shear_force, usual.stiffness};
                    const dda::ShearTrial longer{1e-4, c * joint.shear_force, c * usual.stiffness};
                    const Strength one = dda::strength(law, joint.history, normal, 0.1, trial);
                    const Strength many = dda::strength(law, joint.history, c * normal, c * 0.1, longer);
                    expect_ratio(many, one, c);
                    const JointHistory after =
                        dda::advance(law, joint.history,
                                     {1e-4, 1e-4, normal, 0.1, false, joint.shear_force, usual.stiffness,
                                      dda::StepTime(0.01)});
                    const JointHistory longer_after =
                        dda::advance(law, joint.history,
                                     {1e-4, 1e-4, c * normal, c * 0.1, false, c * joint.shear_force,
                                      c * usual.stiffness, dda::StepTime(0.01)});
                    EXPECT_NEAR(dda::dilation(law, longer_after), dda::dilation(law, after), 1e-15);
                }
            }
        }
    }
}

// The faces of a broken joint that are pulled apart have the shear strength of no normal force; a vertex has
// that of a very short contact.
TYPED_TEST(JointLawConformance, DegenerateContactsHaveTheStrengthOfTheirLimit) {
    for (const JointLaw& law : this->laws()) {
        const JointHistory broken = dda::fresh_history(law, false);
        for (const double normal : {-1e12, -10.0, -1e-12})
            expect_ratio(dda::strength(law, broken, normal, 0.1), dda::strength(law, broken, 0, 0.1), 1);
        for (const double normal : {10.0, 1e5, 1e7})
            expect_ratio(dda::strength(law, broken, normal, 0), dda::strength(law, broken, normal, 1e-15), 1);
    }
}

// Friction takes energy in every displacement, and all joints slip that can.
TYPED_TEST(JointLawConformance, FrictionNeverDrives) {
    for (const JointLaw& law : this->laws()) {
        for (unsigned seed = 1; seed <= 5; ++seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> share(-0.2, 2);
            ShearedJoint joint{dda::fresh_history(law, true)};
            double work = 0;
            for (const double displacement : random_path(seed)) {
                const JointLoad load{usual.normal_force * share(random), usual.length, usual.stiffness};
                const ShearedJoint next = dda::shear(law, joint, displacement, load);
                ASSERT_GE(next.shear_force * (next.slip - joint.slip), 0);
                ASSERT_TRUE(std::isfinite(next.shear_force));
                work += next.shear_force * (next.slip - joint.slip);
                joint = next;
            }
            const double bound = dda::strength(law, joint.history, 1e5, 0.1).forward;
            EXPECT_EQ(work > 0, bound > 0 && std::isfinite(bound));
        }
    }
}

// The slope is exact; the difference quotient of a smooth function with a relative step of 1e-5 has an error
// of 1e-10 and rounding of 1e-11.
TYPED_TEST(JointLawConformance, SlopeIsTheDerivativeOfTheStrength) {
    for (const JointLaw& law : this->laws()) {
        for (const ShearedJoint& joint : sheared(law, random_path(2))) {
            for (const double normal : {-1e5, 1e4, 1.1e5, 1.3e6}) {
                const auto slope = dda::strength_slope(law, joint.history, normal, usual.length);
                if (!slope) continue;
                const double step = 1e-5 * std::abs(normal);
                const Strength above = dda::strength(law, joint.history, normal + step, usual.length);
                const Strength below = dda::strength(law, joint.history, normal - step, usual.length);
                EXPECT_NEAR(slope->forward, (above.forward - below.forward) / (2 * step), 1e-8) << normal;
                EXPECT_NEAR(slope->backward, (above.backward - below.backward) / (2 * step), 1e-8) << normal;
            }
        }
    }
}

// Swapping the two blocks also turns the tangent, so the displacements stay the same. The remaining symmetry
// is that a fresh joint prefers no direction of the tangent.
TYPED_TEST(JointLawConformance, AFreshJointIsSymmetric) {
    for (const JointLaw& law : this->laws()) {
        const std::vector<double> path = random_path(3);
        std::vector<double> mirrored;
        for (const double displacement : path) mirrored.push_back(-displacement);
        const auto there = sheared(law, path), here = sheared(law, mirrored);
        for (std::size_t k = 0; k < there.size(); ++k) {
            EXPECT_EQ(there[k].shear_force, -here[k].shear_force);
            const JointRecord a = dda::record(law, there[k].history), b = dda::record(law, here[k].history);
            EXPECT_EQ(a.stage, b.stage);
            EXPECT_EQ(a.dilation, b.dilation);
            EXPECT_EQ(a.mobilised_ratio, b.mobilised_ratio);
            const Strength s = dda::strength(law, there[k].history, usual.normal_force, usual.length);
            const Strength t = dda::strength(law, here[k].history, usual.normal_force, usual.length);
            EXPECT_EQ(s.forward, t.backward);
            EXPECT_EQ(s.backward, t.forward);
        }
    }
}

TYPED_TEST(JointLawConformance, HistoryDoesNotDependOnHowAPathIsSubdivided) {
    for (const JointLaw& law : this->laws()) {
        for (unsigned seed = 1; seed <= 3; ++seed) {
            const std::vector<double> path = random_path(seed);
            std::vector<double> divided;
            for (const double displacement : path)
                for (const double part : {0.37, 0.5, 0.13}) divided.push_back(part * displacement);
            const auto coarse = sheared(law, path), fine = sheared(law, divided);
            for (std::size_t k = 0; k < coarse.size(); ++k) {
                expect_alike(law, coarse[k], fine[3 * k]);
                if (testing::Test::HasFailure()) FAIL() << "seed " << seed << ", displacement " << k;
            }
        }
    }
}

TYPED_TEST(JointLawConformance, TrialsDoNotChangeTheHistory) {
    for (const JointLaw& law : this->laws()) {
        for (const ShearedJoint& joint : sheared(law, random_path(4))) {
            const JointHistory before = joint.history;
            const Strength at_rest = dda::strength(law, joint.history, usual.normal_force, usual.length);
            for (const double displacement : {5e-3, -5e-3, 0.0}) {
                dda::strength(law, joint.history, 3e5, usual.length, {displacement, joint.shear_force, 8e7});
                dda::shear(law, joint, displacement, usual);
            }
            EXPECT_TRUE(joint.history == before);
            expect_equal(dda::strength(law, joint.history, usual.normal_force, usual.length), at_rest);
        }
    }
}

TYPED_TEST(JointLawConformance, HistoryBelongsToItsLawAndIsPlainData) {
    static_assert(std::is_trivially_copyable_v<typename TypeParam::History>);
    for (const JointLaw& law : this->laws())
        for (const ShearedJoint& joint : sheared(law, random_path(5)))
            EXPECT_EQ(joint.history.index(), law.index());
}

// A law without dilation has none in any history; one with dilation opens or closes some specimen.
TYPED_TEST(JointLawConformance, DilatesSaysWhetherTheRecordHasDilation) {
    for (const JointLaw& law : this->laws()) {
        double largest = 0;
        for (unsigned seed = 1; seed <= 3; ++seed)
            for (const ShearedJoint& joint : sheared(law, random_path(seed)))
                largest = std::max(largest, std::abs(dda::dilation(law, joint.history)));
        EXPECT_EQ(dda::dilates(law), largest > 0);
        EXPECT_TRUE(!dda::dilates_with_slip(law) || dda::dilates(law));
    }
}

/// The joint after its walls have moved in the air.
JointHistory flown(const JointLaw& law, const JointHistory& history, double displacement) {
    dda::ContactMotion motion;
    motion.displacement = motion.slip = displacement;
    motion.length = usual.length;
    return dda::advance(law, history, motion);
}

// In the air a joint goes where its walls go, in one step or in many. It is not worn: where it comes back to
// where it was, it is as strong as it was. A joint that was not below its mated position does not get there.
TYPED_TEST(JointLawConformance, OpenJointsFlyAndWearNothing) {
    if (TypeParam::history_scope != dda::HistoryScope::joint_segment) return;
    for (const JointLaw& law : this->laws()) {
        for (const ShearedJoint& joint : sheared(law, random_path(7))) {
            for (const double displacement : {-8e-3, -1e-4, 1e-4, 8e-3}) {
                const JointHistory away = flown(law, joint.history, displacement);
                JointHistory in_parts = joint.history;
                for (const double part : {0.37, 0.5, 0.13})
                    in_parts = flown(law, in_parts, part * displacement);
                EXPECT_NEAR(dda::dilation(law, in_parts), dda::dilation(law, away), 1e-9);
                EXPECT_GE(dda::dilation(law, away), std::min(dda::dilation(law, joint.history), 0.0));
                if (joint.slip == 0) continue;  // it may find its forward side in the air
                const JointHistory back = flown(law, away, -displacement);
                const JointHistory waited = flown(law, joint.history, 0);
                const Strength returned = dda::strength(law, back, usual.normal_force, usual.length);
                const Strength stayed = dda::strength(law, waited, usual.normal_force, usual.length);
                EXPECT_NEAR(returned.forward, stayed.forward, 1e-9 * usual.normal_force);
                EXPECT_NEAR(returned.backward, stayed.backward, 1e-9 * usual.normal_force);
            }
        }
    }
}

// The two contacts of a joint segment dilate together, so only a segment's history may contain dilation.
TYPED_TEST(JointLawConformance, OnlyJointSegmentsDilate) {
    for (const JointLaw& law : this->laws()) {
        EXPECT_EQ(dda::has_segment_history(law),
                  TypeParam::history_scope == dda::HistoryScope::joint_segment);
        EXPECT_TRUE(!dda::dilates(law) || dda::has_segment_history(law));
    }
}

// The friction coupling replaces the strength by its line: they must be equal, whatever the trial.
TYPED_TEST(JointLawConformance, BoundLineIsTheStrength) {
    for (const JointLaw& law : this->laws()) {
        for (const ShearedJoint& joint : sheared(law, random_path(6))) {
            const auto line = dda::bound_line(law, joint.history);
            if (!line) continue;
            for (const double normal : forces) {
                for (const double length : {0.0, 0.1, 3.0}) {
                    for (const double displacement : {-1e-3, 0.0, 1e-3}) {
                        const Strength s = dda::strength(law, joint.history, normal, length,
                                                         {displacement, joint.shear_force, 8e7});
                        EXPECT_EQ(s.forward, line->strength(normal, length)) << normal << ' ' << length;
                        EXPECT_EQ(s.backward, s.forward) << normal << ' ' << length;
                    }
                }
            }
        }
    }
}

// A law with an envelope has its residual line after the first slip, and its peak line, or the residual one
// if nothing can break, before.
TYPED_TEST(JointLawConformance, EnvelopeHasTheLinesBeforeAndAfterTheFirstSlip) {
    for (const JointLaw& law : this->laws()) {
        const auto envelope = dda::coulomb_envelope(law);
        const JointHistory fresh = dda::fresh_history(law, true);
        if (!envelope) continue;
        ASSERT_TRUE(dda::bound_line(law, fresh));
        EXPECT_TRUE(dda::bound_line(law, fresh) == envelope->peak ||
                    dda::bound_line(law, fresh) == envelope->residual);
        const JointHistory slipped = dda::advance(law, fresh, {1e-3, 1e-3, 1e5, 0.1});
        EXPECT_EQ(dda::bound_line(law, slipped), envelope->residual);
        EXPECT_EQ(dda::bound_line(law, dda::fresh_history(law, false)), envelope->residual);
    }
}

// A part of a joint has at most the spring of the whole, and a longer part has no softer one. Either every
// loaded joint of a law has a spring or none has.
TYPED_TEST(JointLawConformance, ShearStiffnessGrowsWithTheLength) {
    for (const JointLaw& law : this->laws()) {
        bool any = false, all = true;
        for (const ShearedJoint& joint : sheared(law, random_path(7))) {
            for (const double normal : forces) {
                double shorter = 0;
                for (const double length : {0.0, 1e-12, 0.1, 3.0}) {
                    const double stiffness = dda::shear_stiffness(law, joint.history, normal, length);
                    EXPECT_TRUE(stiffness >= shorter && std::isfinite(stiffness)) << normal << ' ' << length;
                    shorter = stiffness;
                }
            }
            const bool has_spring = dda::shear_stiffness(law, joint.history, 1e5, 0.1) > 0;
            any = any || has_spring;
            all = all && has_spring;
        }
        EXPECT_EQ(any, all);
    }
}

// Common histories are stored once, so they must be values that joints have.
TYPED_TEST(JointLawConformance, CommonHistoriesOccur) {
    constexpr auto common = TypeParam::common_histories();
    for (const auto& history : common) {
        bool occurs = false;
        for (const JointLaw& law : this->laws())
            for (const bool intact : {true, false})
                for (const JointHistory& found :
                     {dda::fresh_history(law, intact),
                      dda::advance(law, dda::fresh_history(law, intact), {1e-3, 1e-3, 1e12, 0.1})})
                    occurs = occurs || std::get<typename TypeParam::History>(found) == history;
        EXPECT_TRUE(occurs);
    }
}

// Laws may leave these questions open; these laws must not, or the tests of their answers test nothing.
TEST(JointLaws, AnswerWhatTheyCan) {
    const auto answers = [](const auto& answer_of) {
        std::set<std::string> names;
        const auto ask = [&]<class Law>(std::type_identity<Law>) {
            for (const Law& law : joint_tests::specimens<Law>())
                if (answer_of(JointLaw(law), dda::fresh_history(law, true))) names.insert(Law::name);
        };
        [&]<class... Laws>(std::type_identity<std::variant<Laws...>>) {
            (ask(std::type_identity<Laws>{}), ...);
        }(std::type_identity<JointLaw>{});
        return names;
    };
    const auto lines = answers([](const auto& law, const auto& h) { return dda::bound_line(law, h); });
    const auto envelopes = answers([](const auto& law, const auto&) { return dda::coulomb_envelope(law); });
    const auto slopes =
        answers([](const auto& law, const auto& h) { return dda::strength_slope(law, h, 1e5, 0.1); });
    const auto stiffnesses =
        answers([](const auto& law, const auto& h) { return dda::shear_stiffness(law, h, 1e5, 0.1) > 0; });
    using testing::IsSupersetOf;
    EXPECT_THAT(lines, IsSupersetOf({"mohr-coulomb"}));
    EXPECT_THAT(envelopes, IsSupersetOf({"mohr-coulomb"}));
    EXPECT_THAT(slopes, IsSupersetOf({"mohr-coulomb", "barton-bandis", "cyclic-barton-bandis", "weakening",
                                      "bilinear", "plesha", "two-order-asperities", "stressed-asperities",
                                      "velocity-weakening"}));
    EXPECT_THAT(stiffnesses, IsSupersetOf({"barton-bandis", "cyclic-barton-bandis"}));
}

// Names are the values of `law = "..."`, so no two laws have the same.
TEST(JointLaws, HaveDifferentNames) {
    const auto names = []<class... Laws>(std::type_identity<std::variant<Laws...>>) {
        return std::set<std::string>{Laws::name...};
    }(std::type_identity<JointLaw>{});
    EXPECT_EQ(names.size(), std::variant_size_v<JointLaw>);
}

// The contract refuses a law in which one member is missing or has another type.
template <class Law>
struct CompleteLaw : dda::MohrCoulomb {
    static Law read(const dda::ParameterTable&) { return {}; }
};
struct Complete : CompleteLaw<Complete> {};
struct WithoutDilation : CompleteLaw<WithoutDilation> {
    void dilates() const = delete;
};
struct WithoutBoundLine : CompleteLaw<WithoutBoundLine> {
    void bound_line(const History&) const = delete;
};
struct WithWrongScope : CompleteLaw<WithWrongScope> {
    static constexpr bool history_scope = true;
};
struct WithoutReader : CompleteLaw<Complete> {};
static_assert(dda::JointLawContract<Complete>);
static_assert(!dda::JointLawContract<WithoutDilation>);
static_assert(!dda::JointLawContract<WithoutBoundLine>);
static_assert(!dda::JointLawContract<WithWrongScope>);
static_assert(!dda::JointLawContract<WithoutReader>);

// A joint at rest under a changing force, as in a static stage, does not wear. Its history may contain the
// largest stress, from which the spring follows.
TYPED_TEST(JointLawConformance, RestChangesNothing) {
    for (const JointLaw& law : this->laws()) {
        ShearedJoint joint =
            dda::shear(law, {dda::fresh_history(law, true)}, 0, {usual.normal_force * 10, 0.1, 8e7});
        const JointHistory before = joint.history;
        for (int k = 0; k < 10; ++k)
            joint = dda::shear(law, joint, 0, {usual.normal_force * (k + 1), 0.1, 8e7});
        EXPECT_TRUE(joint.history == before);
    }
}

}  // namespace
}  // namespace rockslope::conformance_test
