// No joint creates energy: the work that goes into a joint along a path of displacement and normal force, by
// every law of the list. The increments are finite, and the work is known to a thousandth of the normal force
// times the displacement.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "dda/joint/shear_step.hpp"
#include "dda/joint/shear_test.hpp"
#include "specimens.hpp"
#include "support/external_data.hpp"

namespace rockslope::joint_energy_test {
namespace {

using dda::JointLaw;
using dda::ShearedJoint;

constexpr double length = 1;  ///< m

/// A joint of a metre that is sheared and loaded, and the work done on it since it was first loaded: W =
/// integral of S du - N dd, J per metre, with the dilation d.
class WorkedJoint {
  public:
    WorkedJoint(const JointLaw& law, double normal_force) : law_(law) {
        joint_.history = dda::fresh_history(law, true);
        const bool has_spring = dda::shear_stiffness(law, joint_.history, normal_force, length) > 0;
        if (!has_spring) stiffness_ = 1e4 * normal_force;
        load_to(normal_force, {});
    }
    double work() const { return work_; }
    /// The work less what the joint stores, Eq. (78), J per metre: friction has taken it.
    double dissipation() const {
        const dda::LockedDilation dilating = dda::locked_dilation(law_, joint_.history);
        const double force = joint_.shear_force - dilating.shear_force(joint_.normal_force, 1);
        return work_ - dilating.stored_energy(force, spring(), dda::dilation(law_, joint_.history), 1);
    }

    /// Moves to a displacement and a normal force in a straight line, in steps of at most `increment` (m).
    void move(double displacement, double normal_force, double increment) {
        const double change = displacement - displacement_, load = normal_force - joint_.normal_force;
        const double start = displacement_, from = joint_.normal_force;
        const int steps =
            1 + static_cast<int>(std::max(std::abs(change) / increment, load != 0 ? 20.0 : 0.0));
        for (int k = 1; k <= steps; ++k)
            step((k == steps ? displacement : start + change * k / steps) - displacement_,
                 k == steps ? normal_force : from + load * k / steps);
    }

  private:
    double spring() const {
        if (stiffness_ > 0) return stiffness_;
        return dda::shear_stiffness(law_, joint_.history, joint_.normal_force, length);
    }
    void load_to(double normal_force, const dda::StepTime& time) {
        joint_.normal_force = normal_force;
        joint_ = dda::shear(law_, joint_, 0, {normal_force, length, spring(), time});
    }
    void step(double displacement, double normal_force) {
        const dda::JointLoad load{normal_force, length, spring(), dda::StepTime(1e-3)};
        const ShearedJoint loaded = dda::shear(law_, joint_, 0, load);
        const ShearedJoint moved = dda::shear(law_, loaded, displacement, load);
        const double dilation = dda::dilation(law_, moved.history) - dda::dilation(law_, loaded.history);
        work_ += (loaded.shear_force + moved.shear_force) / 2 * displacement - moved.normal_force * dilation;
        displacement_ += displacement;
        joint_ = moved;
    }

    const JointLaw& law_;
    ShearedJoint joint_;
    double stiffness_ = 0;
    double displacement_ = 0;
    double work_ = 0;
};

/// A displacement and a normal force on the way of a path.
struct Target {
    double displacement = 0, normal_force = 0;
};

/// The work at each target of a path; the first one is the virgin joint's.
std::vector<double> work_along(const JointLaw& law, const std::vector<Target>& path, double increment) {
    WorkedJoint joint(law, path.front().normal_force);
    std::vector<double> work = {0};
    for (std::size_t k = 1; k < path.size(); ++k) {
        joint.move(path[k].displacement, path[k].normal_force, increment);
        work.push_back(joint.work());
    }
    return work;
}

/// The largest fall of the work: below zero, and from one open instant to a later one, where nothing is
/// stored.
double largest_fall(const std::vector<Target>& path, const std::vector<double>& work) {
    double fall = 0, highest = 0;
    for (std::size_t k = 0; k < path.size(); ++k) {
        fall = std::max(fall, -work[k]);
        if (path[k].normal_force > 0) continue;
        fall = std::max(fall, highest - work[k]);
        highest = std::max(highest, work[k]);
    }
    return fall;
}

/// Random swings of a few millimetres at normal stresses of 0 to twice the first one.
std::vector<Target> random_path(unsigned seed, double stress, double reach) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(0, 1);
    std::vector<Target> path = {{0, stress}};
    for (int k = 0; k < 40; ++k) {
        Target next = path.back();
        if (any(random) < 0.5) next.normal_force = any(random) < 0.2 ? 0 : 2 * stress * any(random);
        if (any(random) < 0.8)
            next.displacement = reach * (2 * any(random) - 1) * std::pow(10, -2 * any(random));
        path.push_back(next);
    }
    path.push_back({path.back().displacement, 0});
    return path;
}

dda::CyclicBartonBandis flat() {
    dda::CyclicBartonBandis law;
    law.barton = {2, 50e6, 18 * joint_tests::degree};
    law.peak_displacement = 2e-3;
    const dda::RoughnessTable wear = {{{0, 1}, {1, 1}}};
    law.cycles = {{wear, wear, wear, wear}};
    law.unsigned_ratios = true;
    law.damage = 1;
    return law;
}

/// A recorded path of displacement and normal force.
struct RecordedPath {
    std::string material;
    std::vector<Target> path;

    dda::CyclicBartonBandis law() const {
        if (material == "flat") return flat();
        return material == "granite" ? joint_tests::granite() : joint_tests::marble();
    }
    /// J/m2, a thousandth of the normal stress times the peak displacement.
    double tolerance() const { return 1e-3 * path.front().normal_force * law().peak_displacement; }
};

std::map<int, RecordedPath> recorded_paths(const std::filesystem::path& table) {
    std::map<int, RecordedPath> paths;
    std::ifstream file(table);
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream row(line);
        int path = 0;
        std::string material;
        double time = 0;
        Target target;
        row >> path >> material >> time >> target.displacement >> target.normal_force;
        paths[path].material = material;
        paths[path].path.push_back(target);
    }
    return paths;
}

/// Whether a recorded path repeats a cycle of four points from its seventh point on.
bool is_closed(int path) {
    return path % 4 == 2 && path <= 10;
}

TEST(JointEnergy, DoesNotFallOnTheRecordedPaths) {
    const auto folder = external_data("reference/dilation");
    if (!folder) GTEST_SKIP() << external_data_missing("reference/dilation");
    const auto paths = recorded_paths(*folder / "energy_paths.csv");
    ASSERT_EQ(paths.size(), 21U);
    for (const auto& [index, one] : paths) {
        const std::vector<double> work = work_along(one.law(), one.path, one.law().peak_displacement / 250);
        EXPECT_LT(largest_fall(one.path, work), one.tolerance()) << index;
        if (!is_closed(index)) continue;
        for (std::size_t k = 10; k < work.size(); k += 4)
            EXPECT_GT(work[k] - work[k - 4], -one.tolerance()) << index << ' ' << k;
    }
}

/// The shear test of joint-shear along a path of displacement and normal stress.
dda::ShearTest test_along(const dda::CyclicBartonBandis& law, const std::vector<Target>& path) {
    dda::ShearTest test;
    test.material.law = law;
    test.length = length;
    test.normal_stress = path.front().normal_force;
    test.boundary = dda::NormalBoundary::prescribed_stress;
    test.increment = law.peak_displacement / 250;
    for (const Target& target : path) {
        test.path.push_back(target.displacement);
        test.path_stress.push_back(target.normal_force);
    }
    return test;
}

// The program's own answer to the question, by its work and its created energy.
TEST(JointEnergy, OfAShearTestDoesNotFallOnTheRecordedPaths) {
    const auto folder = external_data("reference/dilation");
    if (!folder) GTEST_SKIP() << external_data_missing("reference/dilation");
    const auto paths = recorded_paths(*folder / "energy_paths.csv");
    ASSERT_EQ(paths.size(), 21U);
    for (const auto& [index, one] : paths) {
        const dda::ShearTest test = test_along(one.law(), one.path);
        EXPECT_LT(created_energy(run_shear_test(test)), one.tolerance()) << index;
        if (!is_closed(index)) continue;
        const auto points = shear_test_at_path_points(test);
        for (std::size_t k = 10; k < points.size(); k += 4)
            EXPECT_GT(points[k].work - points[k - 4].work, -one.tolerance()) << index << ' ' << k;
    }
}

TEST(JointEnergy, OfAShearTestDoesNotFallOnRandomPaths) {
    const double stress = 1e6, reach = 5e-3;
    for (const auto& law : {joint_tests::granite(), joint_tests::marble(), flat()})
        for (unsigned seed = 0; seed < 100; ++seed) {
            const auto rows = run_shear_test(test_along(law, random_path(seed, stress, reach)));
            EXPECT_LT(created_energy(rows), 1e-3 * stress * law.peak_displacement) << seed;
        }
}

template <class Law>
class EnergyOfLaw : public testing::Test {};
TYPED_TEST_SUITE(EnergyOfLaw, joint_tests::AsTypes<JointLaw>::type, joint_tests::NameOfLaw);

TYPED_TEST(EnergyOfLaw, DoesNotFallOnRandomPaths) {
    const double stress = 1e5, reach = 5e-3;
    for (const TypeParam& specimen : joint_tests::specimens<TypeParam>()) {
        const JointLaw law = specimen;
        for (unsigned seed = 0; seed < 1000; ++seed) {
            const std::vector<Target> path = random_path(seed, stress, reach);
            EXPECT_LT(largest_fall(path, work_along(law, path, 5e-5)), 1e-3 * stress * reach) << seed;
        }
    }
}

// A loop of displacement and normal force, small against the way that led to it, and repeated until the joint
// has got used to it. What it takes per turn is friction; a joint that stores its energy elsewhere than its
// forces say would give some away in each turn.
TYPED_TEST(EnergyOfLaw, IsNotGainedInClosedLoops) {
    const double stress = 1e5, reach = 5e-3;
    for (const TypeParam& specimen : joint_tests::specimens<TypeParam>()) {
        const JointLaw law = specimen;
        for (unsigned seed = 0; seed < 100; ++seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> any(0, 1);
            const double size = 1e-3 * std::pow(10, -2 * any(random));
            const double centre = reach * (2 * any(random) - 1);
            std::vector<Target> loop;
            for (int k = 0; k < 4; ++k)
                loop.push_back({centre + size * (2 * any(random) - 1), stress * (0.2 + 1.8 * any(random))});
            WorkedJoint joint(law, stress);
            joint.move(centre, stress, 5e-5);
            std::vector<double> dissipation;
            for (int turn = 0; turn < 12; ++turn) {
                for (const Target& target : loop)
                    joint.move(target.displacement, target.normal_force, size / 50);
                dissipation.push_back(joint.dissipation());
            }
            EXPECT_GT(dissipation[11] - dissipation[7], -4e-3 * stress * size) << seed;
        }
    }
}

/// A rigid block of one square metre of joint on the law: slip u and rise n, a linear normal spring, and
/// kicks in both directions. Its motion opens and closes the joint at speed.
class BlockOnAJoint {
  public:
    BlockOnAJoint(const JointLaw& law, double step) : law_(law), step_(step) {
        joint_.history = dda::fresh_history(law, true);
        rise_ = -weight / normal_stiffness;
        const bool has_spring = dda::shear_stiffness(law, joint_.history, weight, length) > 0;
        if (!has_spring) stiffness_ = normal_stiffness;
        joint_ = dda::shear(law, joint_, 0, {weight, length, spring()});
    }

    void kick(double along, double up) {
        const double before = kinetic();
        along_ += along;
        up_ += up;
        work_ += kinetic() - before;
    }
    void advance() {
        rise_ += up_ * step_;  // velocities, then positions, then forces: the spring gains nothing
        const double penetration = dda::dilation(law_, joint_.history) - rise_;
        const double normal = normal_stiffness * std::max(penetration, 0.0);
        joint_ = dda::shear(law_, joint_, along_ * step_, {normal, length, spring(), dda::StepTime(step_)});
        open_ = !(normal > 0);
        opened_ += open_ && !was_open_;
        was_open_ = open_;
        along_ -= joint_.shear_force / mass * step_;
        up_ += (normal - weight) / mass * step_;
    }
    /// Work of the kicks less all that is stored: what friction has taken, J per metre.
    double dissipation() const {
        const double penetration = std::max(dda::dilation(law_, joint_.history) - rise_, 0.0);
        const dda::LockedDilation dilating = dda::locked_dilation(law_, joint_.history);
        const double force = joint_.shear_force - dilating.shear_force(joint_.normal_force, 1);
        const double joint =
            open_ ? 0 : dilating.stored_energy(force, spring(), dda::dilation(law_, joint_.history), 1);
        return work_ - (kinetic() + weight * (rise_ + weight / normal_stiffness) +
                        normal_stiffness * penetration * penetration / 2 -
                        weight * weight / normal_stiffness / 2 + joint);
    }
    double work() const { return work_; }
    int times_opened() const { return opened_; }

    static constexpr double mass = 2500, weight = 9.81 * mass;  ///< kg and N per metre
    static constexpr double normal_stiffness = 1e9;             ///< N/m per metre

  private:
    double kinetic() const { return mass * (along_ * along_ + up_ * up_) / 2; }
    double spring() const {
        if (stiffness_ > 0) return stiffness_;
        return dda::shear_stiffness(law_, joint_.history, joint_.normal_force, length);
    }

    const JointLaw& law_;
    double step_;
    ShearedJoint joint_;
    double stiffness_ = 0;
    double rise_ = 0, along_ = 0, up_ = 0;  ///< m and m/s
    double work_ = 0;
    bool open_ = false, was_open_ = false;
    int opened_ = 0;
};

// A block that is kicked about, hops, and lands. What it has been given is what it has and what friction has
// taken: friction never gives back, whatever the law. The explicit integration errs by the part that it moves
// the block in a step of the normal spring's swing, sqrt(k/m) dt = 6e-3 of the energy in it.
TYPED_TEST(EnergyOfLaw, IsNotGainedByABlockThatHops) {
    if (TypeParam::history_scope != dda::HistoryScope::joint_segment) return;
    int opened = 0;
    for (const TypeParam& specimen : joint_tests::specimens<TypeParam>()) {
        const JointLaw law = specimen;
        // The dilation by slip follows the normal force within a step, Eq. (85), which this integration does
        // in the next one: its error there is of the order of the step.
        const double step = dda::dilates_with_slip(law) ? 1e-6 : 1e-5;
        const unsigned seeds = dda::dilates_with_slip(law) ? 4 : 20;
        for (unsigned seed = 0; seed < seeds; ++seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> any(0, 1);
            BlockOnAJoint block(law, step);
            double highest = 0, fall = 0;
            for (int k = 0; k < 10; ++k) {
                block.kick(0.6 * (any(random) - 0.5), 0.3 * any(random) * (any(random) < 0.5));
                for (int n = 0; n * step < 0.04; ++n) block.advance();
                fall = std::max(fall, highest - block.dissipation());
                highest = std::max(highest, block.dissipation());
            }
            EXPECT_LT(fall, 1e-2 * block.work()) << seed;
            opened += block.times_opened();
        }
    }
    EXPECT_GT(opened, 4) << "the blocks hop";
}

}  // namespace
}  // namespace rockslope::joint_energy_test
