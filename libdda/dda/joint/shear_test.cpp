#include "dda/joint/shear_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dda/joint/shear_step.hpp"

namespace rockslope::dda {

namespace {

/// Closure of the joint and displacement of the boundary, normal to the joint, since the start of the test,
/// m.
double total_closure(const ShearTest& test, double normal_stress) {
    const NormalClosure closing{test.material.normal_stiffness, test.material.largest_closure};
    const double own =
        closing.stiffness > 0 ? closing.closure(normal_stress) - closing.closure(test.normal_stress) : 0;
    if (test.boundary != NormalBoundary::constant_stiffness) return own;
    return own + (normal_stress - test.normal_stress) / test.boundary_stiffness;
}

class Specimen {
  public:
    explicit Specimen(const ShearTest& test)
        : test_(test), stiffness_(shear_stiffness(test) * test.length), normal_stress_(test.normal_stress) {
        joint_ = shear(law(), {fresh_history(law(), true)}, 0, load(normal_stress_, at_rest));
    }

    /// Shears it to a displacement from the start. @param prescribed Pa, normal stress at the end, if it is
    /// prescribed.
    void shear_to(double displacement, double prescribed) {
        const double increment = displacement - displacement_, stress_before = normal_stress_;
        if (test_.boundary == NormalBoundary::prescribed_stress) {
            if (prescribed != normal_stress_) joint_ = after(0, prescribed);
            normal_stress_ = prescribed;
        } else if (test_.boundary != NormalBoundary::constant_stress) {
            normal_stress_ = equilibrium(increment);
        }
        const ShearedJoint before = joint_;
        joint_ = after(increment, normal_stress_);
        displacement_ += increment;
        const bool changes_first = test_.boundary == NormalBoundary::prescribed_stress;
        add_work(before, increment, changes_first ? normal_stress_ : (stress_before + normal_stress_) / 2);
    }

    ShearTestRow row() const {
        const JointRecord joint_record = record(law(), joint_.history);
        return {displacement_,  joint_.shear_force / test_.length,
                normal_stress_, joint_record.dilation,
                joint_.slip,    joint_.sliding,
                work_,          joint_record};
    }

  private:
    const JointLaw& law() const { return test_.material.law; }
    /// The spring of a rough joint is that of its rest at the start; the test is slow, but it is not at rest.
    static constexpr StepTime at_rest{}, slow = StepTime(std::numeric_limits<double>::infinity());
    JointLoad load(double normal_stress, const StepTime& time) const {
        return {normal_stress * test_.length, test_.length, stiffness_, time};
    }
    ShearedJoint after(double displacement, double normal_stress) const {
        return shear(law(), joint_, displacement, load(normal_stress, slow));
    }

    /// Normal stress at which dilation and total closure are equal, Eq. (67), or 0 if the joint opens. Secant
    /// method within a bracket.
    double equilibrium(double displacement) const {
        const auto excess = [&](double stress) {
            return total_closure(test_, stress) - dilation(law(), after(displacement, stress).history);
        };
        double low = 0, below = excess(low);
        if (below >= 0) return 0;
        double high = std::max(2 * normal_stress_, test_.normal_stress), above = excess(high);
        while (above < 0) {
            high *= 2;
            above = excess(high);
        }
        for (int k = 0; k < 200 && high - low > 1e-13 * high; ++k) {
            double guess = high - above * (high - low) / (above - below);
            if (k % 3 == 2 || !(guess > low && guess < high)) guess = (low + high) / 2;
            const double value = excess(guess);
            (value < 0 ? low : high) = guess;
            (value < 0 ? below : above) = value;
        }
        return -below < above ? low : high;  // the dilation has a small jump at a reversal
    }

    /// The work of an increment, Eq. (84). @param normal_stress Pa, mean of the increment.
    void add_work(const ShearedJoint& before, double increment, double normal_stress) {
        const double shear_stress = (before.shear_force + joint_.shear_force) / (2 * test_.length);
        const double dilated = dilation(law(), joint_.history) - dilation(law(), before.history);
        work_ += shear_stress * increment - normal_stress * dilated;
    }

    const ShearTest& test_;
    double stiffness_;  ///< N/m per metre
    double normal_stress_;
    double displacement_ = 0;
    double work_ = 0;  ///< J/m2
    ShearedJoint joint_;
};

}  // namespace

double shear_stiffness(const ShearTest& test) {
    const JointLaw& law = test.material.law;
    const double law_stiffness =
        shear_stiffness(law, fresh_history(law, true), test.normal_stress * test.length, test.length);
    return test.material.shear_spring(0, test.length, law_stiffness) / test.length;
}

namespace {

/// Least number of increments on a part of the path along which the normal stress is prescribed to change:
/// the joint passes through stresses that differ by a twentieth of the change.
constexpr int least_stress_changes = 20;

/// Shears the specimen along the path. Calls `each` with the specimen after every increment, and with whether
/// it is at a point of the path.
template <class Each>
void shear_along_path(const ShearTest& test, Each each) {
    Specimen specimen(test);
    double from = 0, stress_from = test.normal_stress;
    for (std::size_t k = 0; k < test.path.size(); ++k) {
        const double to = test.path[k];
        const double stress_to = test.path_stress.empty() ? test.normal_stress : test.path_stress[k];
        const auto parts =
            std::max(static_cast<int>(std::ceil(std::abs(to - from) / test.increment * (1 - 1e-12))),
                     stress_to != stress_from ? least_stress_changes : 1);
        for (int part = 1; part <= parts; ++part) {
            const double share = static_cast<double>(part) / parts;
            specimen.shear_to(part == parts ? to : from + (to - from) * share,
                              part == parts ? stress_to : stress_from + (stress_to - stress_from) * share);
            each(specimen, part == parts);
        }
        from = to;
        stress_from = stress_to;
    }
}

}  // namespace

double created_energy(const std::vector<ShearTestRow>& rows) {
    double fall = 0, highest = 0;
    for (const ShearTestRow& row : rows) {
        fall = std::max(fall, -row.work);
        if (row.normal_stress > 0) continue;
        fall = std::max(fall, highest - row.work);
        highest = std::max(highest, row.work);
    }
    return fall;
}

std::vector<ShearTestRow> run_shear_test(const ShearTest& test) {
    std::vector<ShearTestRow> rows = {Specimen(test).row()};
    shear_along_path(test, [&](const Specimen& specimen, bool) { rows.push_back(specimen.row()); });
    return rows;
}

std::vector<ShearTestRow> shear_test_at_path_points(const ShearTest& test) {
    std::vector<ShearTestRow> rows;
    shear_along_path(test, [&](const Specimen& specimen, bool at_point) {
        if (at_point) rows.push_back(specimen.row());
    });
    return rows;
}

}  // namespace rockslope::dda
