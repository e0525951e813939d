#pragma once

#include <limits>
#include <string>
#include <vector>

#include "support/report_row.hpp"

namespace rockslope::verification {

/// How far a result may be from what is expected. The tolerance recorded is the one asserted.
struct Tolerance {
    ToleranceKind kind = ToleranceKind::relative;
    double value = 0;
};
/// A share of the expected value.
inline Tolerance relative(double share) {
    return {ToleranceKind::relative, share};
}
/// An amount in the quantity's unit.
inline Tolerance absolute(double amount) {
    return {ToleranceKind::absolute, amount};
}

/// A set-up of one case of the catalogue. Each call asserts (a GoogleTest expectation at the caller's line)
/// and records a row of the report in the folder that the environment variable DDA_VERIFICATION_REPORT names;
/// without that variable it only asserts.
class Case {
  public:
    /// @param id of the catalogue; @param set_up what tells this set-up from the others of the case; @param
    /// reason why the tolerances are what they are.
    Case(std::string id, std::string set_up, std::string reason);

    /// omega_contact * dt of the run that the following rows come from, dimensionless.
    Case& contact_frequency_step(double value);

    /// A number that must come out within the tolerance.
    void expect(const std::string& quantity, const std::string& unit, double ours, double expected,
                Tolerance tolerance, const char* file = __builtin_FILE(), int line = __builtin_LINE()) const;
    /// A number whose magnitude must stay below a limit.
    void expect_below(const std::string& quantity, const std::string& unit, double ours, double limit,
                      const char* file = __builtin_FILE(), int line = __builtin_LINE()) const;
    /// A number that must exceed a limit.
    void expect_above(const std::string& quantity, const std::string& unit, double ours, double limit,
                      const char* file = __builtin_FILE(), int line = __builtin_LINE()) const;
    /// A word: the mode of failure, or whether something moves.
    void expect_outcome(const std::string& quantity, const std::string& ours, const std::string& expected,
                        const char* file = __builtin_FILE(), int line = __builtin_LINE()) const;
    /// A number that is reported beside its reference and not judged.
    void inform(const std::string& quantity, const std::string& unit, double ours, double reference) const;
    /// A number that is reported and has nothing to be compared with.
    void inform(const std::string& quantity, const std::string& unit, double ours) const;
    /// A number known to be outside its tolerance: the row says so, with `why`. Fails when it has come
    /// within, so that the list of misses cannot outlive its cause.
    void expect_miss(const std::string& quantity, const std::string& unit, double ours, double expected,
                     Tolerance tolerance, const std::string& why, const char* file = __builtin_FILE(),
                     int line = __builtin_LINE()) const;

  private:
    Row row(const std::string& quantity, const std::string& unit) const;
    Row compared(const std::string& quantity, const std::string& unit, double ours, double expected,
                 Tolerance tolerance) const;

    std::string id_;
    std::string set_up_;
    std::string reason_;
    double contact_frequency_step_ = std::numeric_limits<double>::quiet_NaN();
};

/// One line of a picture.
struct Curve {
    std::string name;
    std::vector<double> x;
    std::vector<double> y;
};

/// Records curves that the report draws as one picture below the case's table. The first is drawn as the
/// reference.
/// @param slug tells the case's pictures apart: letters, digits and dashes.
void record_picture(const std::string& id, const std::string& slug, const std::string& title,
                    const std::string& x_label, const std::string& y_label, const std::vector<Curve>& curves);

}  // namespace rockslope::verification
