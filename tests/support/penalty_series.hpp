#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::verification {

/// How contacts keep blocks apart: springs of a multiple of Young's modulus, alone or augmented.
struct ContactSetting {
    double penalty_over_e;
    double tolerance = 0;  ///< m, of penetration; 0: springs alone

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

/// The settings between which a static answer must not change.
inline std::vector<ContactSetting> settings(double tolerance) {
    return {{1}, {100}, {1, tolerance}, {100, tolerance}};
}

using Answer = std::function<double(const ContactSetting&)>;

/// Order at which an answer approaches its limit as the penalty grows: the slope of a straight line through
/// the logarithms of the changes from each penalty of 10 to 10 000 E to the next. The limit need not be
/// known.
struct PenaltySeries {
    double order = 0;
    double limit = 0;                                    ///< extrapolated at first order from the last two
    std::vector<double> penalty = {1e1, 1e2, 1e3, 1e4};  ///< over E
    std::vector<double> answer;

    explicit PenaltySeries(const Answer& of) {
        for (const double p : penalty) answer.push_back(of({p}));
        // Least squares over three points one decade apart need the outer two only.
        order = std::log10((answer[0] - answer[1]) / (answer[2] - answer[3])) / 2;
        limit = answer[3] + (answer[3] - answer[2]) / 9;
    }
    /// Distance from the limit against the penalty, beside the first order through its last point.
    void draw(const std::string& id, const std::string& quantity) const {
        Curve line{"first order", {}, {}};
        Curve engine{"engine", {}, {}};
        for (std::size_t k = 0; k < penalty.size(); ++k) {
            line.x.push_back(std::log10(penalty[k]));
            line.y.push_back(std::log10(std::abs(answer[3] - limit)) + 4 - line.x.back());
            engine.x.push_back(line.x.back());
            engine.y.push_back(std::log10(std::abs(answer[k] - limit)));
        }
        record_picture(id, "penalty", id + ": " + quantity + ", its error by the contacts' give",
                       "log₁₀ of penalty over E", "log₁₀ of the error in m", {line, engine});
    }
};

/// How a displacement depends on the contacts' giving way.
struct ComplianceBounds {
    double tolerance;  ///< m, of penetration, when augmented
    double augmented;  ///< m, what penetrations of the tolerance make of it at most
    double plain;      ///< m, what springs of 1 E make of it at most; those of n E a share of 1/n
};

/// Asserts and records that springs alone err by the first order in 1/penalty and by no more than they give
/// way, and that augmented contacts reach the limit whatever their penalty.
inline void expect_first_order(const std::string& id, const std::string& set_up, const std::string& quantity,
                               const ComplianceBounds& give, const Answer& of) {
    const PenaltySeries series(of);
    series.draw(id, quantity);
    Case(id, set_up + ", penalties of 10 to 10 000 E",
         "an exact first order but for the share of forces among contacts, which changes with the penalty")
        .expect("order of " + quantity + " in 1/penalty", "", series.order, 1, absolute(.02));
    for (const double penalty : {1., 100.}) {
        const ContactSetting plain{penalty};
        const ContactSetting augmented{penalty, give.tolerance};
        Case(id, set_up + ", " + plain.name(), "what the springs give way under the weight")
            .expect(quantity, "m", of(plain), series.limit, absolute(give.plain / penalty));
        Case(id, set_up + ", " + augmented.name(), "what penetrations of the tolerance make of it")
            .expect(quantity, "m", of(augmented), series.limit, absolute(give.augmented));
    }
}

}  // namespace rockslope::verification
