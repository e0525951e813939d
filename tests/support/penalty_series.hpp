#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::verification {

/// Stiffness of the contacts: a multiple of Young's modulus, with or without augmentation.
struct ContactSetting {
    double penalty_over_e;
    double tolerance = 0;  ///< m, penetration tolerance of augmented contacts; 0: pure penalty

    void apply(scene::Scene& s) const {
        s.model.normal_penalty = s.model.shear_penalty =
            penalty_over_e * s.model.block_materials[0].youngs_modulus;
        s.model.penetration_tolerance = tolerance;
    }
    std::string name() const {
        const std::string springs = "penalty " + to_text(penalty_over_e) + " E";
        return tolerance > 0 ? springs + ", augmented to " + to_text(tolerance) + " m" : springs;
    }
};

/// Settings that must all give the same static answer.
inline std::vector<ContactSetting> settings(double tolerance) {
    return {{1}, {100}, {1, tolerance}, {100, tolerance}};
}

using Answer = std::function<double(const ContactSetting&)>;

/// Order of convergence of an answer with the penalty: slope of the straight line through the logarithms of
/// the changes between successive penalties from 10 to 10 000 E. The limit need not be known.
struct PenaltySeries {
    double order = 0;
    double limit = 0;                                    ///< extrapolated at first order from the last two
    std::vector<double> penalty = {1e1, 1e2, 1e3, 1e4};  ///< over E
    std::vector<double> answer;

    explicit PenaltySeries(const Answer& of) {
        for (const double p : penalty) answer.push_back(of({p}));
        // The least-squares slope of three equidistant points depends on the outer two only.
        order = std::log10((answer[0] - answer[1]) / (answer[2] - answer[3])) / 2;
        limit = answer[3] + (answer[3] - answer[2]) / 9;
    }
    /// Records a picture: error against penalty, and the first order through the last point.
    void draw(const std::string& id, const std::string& quantity) const {
        Curve line{"first order", {}, {}};
        Curve engine{"engine", {}, {}};
        for (std::size_t k = 0; k < penalty.size(); ++k) {
            line.x.push_back(std::log10(penalty[k]));
            line.y.push_back(std::log10(std::abs(answer[3] - limit)) + 4 - line.x.back());
            engine.x.push_back(line.x.back());
            engine.y.push_back(std::log10(std::abs(answer[k] - limit)));
        }
        record_picture(id, "penalty", id + ": " + quantity + ", error against penalty",
                       "log₁₀ of penalty over E", "log₁₀ of the error in m", {line, engine});
    }
};

/// Bounds of the error of a displacement by the compliance of the contacts.
struct ComplianceBounds {
    double tolerance;  ///< m, penetration tolerance of augmented contacts
    double augmented;  ///< m, largest error with augmented contacts
    double plain;      ///< m, largest error with a penalty of 1 E; with n E it is 1/n of this
};

/// Asserts and records that the error of pure penalty contacts is of first order in 1/penalty and within the
/// bounds, and that augmented contacts give the limit with every penalty.
inline void expect_first_order(const std::string& id, const std::string& set_up, const std::string& quantity,
                               const ComplianceBounds& bounds, const Answer& of) {
    const PenaltySeries series(of);
    series.draw(id, quantity);
    Case(
        id, set_up + ", penalties of 10 to 10 000 E",
        "exact first order but for the distribution of forces among contacts, which changes with the penalty")
        .expect("order of " + quantity + " in 1/penalty", "", series.order, 1, absolute(.02));
    for (const double penalty : {1., 100.}) {
        const ContactSetting plain{penalty};
        const ContactSetting augmented{penalty, bounds.tolerance};
        Case(id, set_up + ", " + plain.name(), "compliance of the springs under the weight")
            .expect(quantity, "m", of(plain), series.limit, absolute(bounds.plain / penalty));
        Case(id, set_up + ", " + augmented.name(), "effect of penetrations of the tolerance")
            .expect(quantity, "m", of(augmented), series.limit, absolute(bounds.augmented));
    }
}

}  // namespace rockslope::verification
