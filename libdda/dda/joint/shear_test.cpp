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

    /// Shears it to a displacement from the start.
    void shear_to(double displacement) {
        const double increment = displacement - displacement_;
        if (test_.boundary != NormalBoundary::constant_stress) normal_stress_ = equilibrium(increment);
        joint_ = after(increment, normal_stress_);
        displacement_ += increment;
    }

    ShearTestRow row() const {
        const JointRecord joint_record = record(law(), joint_.history);
        return {displacement_,  joint_.shear_force / test_.length,
                normal_stress_, joint_record.dilation,
                joint_.slip,    joint_.sliding,
                joint_record};
    }

  private:
    const JointLaw& law() const { return test_.material.law; }
    /// The spring of a rough joint is that of its rest at the start; the test is slow, but it is not at rest.
    static constexpr double at_rest = 0, slow = std::numeric_limits<double>::infinity();
    JointLoad load(double normal_stress, double duration) const {
        return {normal_stress * test_.length, test_.length, stiffness_, duration};
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

    const ShearTest& test_;
    double stiffness_;  ///< N/m per metre
    double normal_stress_;
    double displacement_ = 0;
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

/// Shears the specimen along the path. Calls `each` with the specimen after every increment, and with whether
/// it is at a point of the path.
template <class Each>
void shear_along_path(const ShearTest& test, Each each) {
    Specimen specimen(test);
    double from = 0;
    for (const double to : test.path) {
        const auto parts =
            std::max(static_cast<int>(std::ceil(std::abs(to - from) / test.increment * (1 - 1e-12))), 1);
        for (int part = 1; part <= parts; ++part) {
            const double share = static_cast<double>(part) / parts;
            specimen.shear_to(part == parts ? to : from + (to - from) * share);
            each(specimen, part == parts);
        }
        from = to;
    }
}

}  // namespace

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
