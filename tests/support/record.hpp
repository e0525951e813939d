#pragma once

#include <limits>
#include <string>
#include <vector>

#include "support/report_row.hpp"

namespace rockslope::verification {

/// Largest difference of a result from its expected value. The tolerance recorded is the one asserted.
struct Tolerance {
    ToleranceKind kind = ToleranceKind::relative;
    double value = 0;
};
/// A fraction of the expected value.
inline Tolerance relative(double fraction) {
    return {ToleranceKind::relative, fraction};
}
/// An amount in the quantity's unit.
inline Tolerance absolute(double amount) {
    return {ToleranceKind::absolute, amount};
}

/// The tolerance that a number is known to miss, and the reason.
struct KnownMiss {
    Tolerance tolerance;
    std::string reason;
};

/// A line of a test.
struct TestLine {
    const char* file = nullptr;
    int line = 0;

    /// The line of the call; as a default argument, the line of the call of that function.
    static TestLine here(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
        return {file, line};
    }
};

/// A set-up of a case of the catalogue. Each call asserts (a GoogleTest expectation at the caller's line) and
/// records a row of the report, in the folder of the environment variable DDA_VERIFICATION_REPORT. Without
/// that variable it only asserts.
class Case {
  public:
    /// @param id of the catalogue. @param set_up distinguishes this set-up from the others of the case.
    /// @param reason of the tolerances.
    Case(std::string id, std::string set_up, std::string reason);

    /// Sets omega_contact * dt of the run of the following rows, dimensionless.
    Case& contact_frequency_step(double value);

    /// Expects a number within the tolerance.
    void expect(const std::string& quantity, const std::string& unit, double ours, double expected,
                Tolerance tolerance, TestLine at = TestLine::here()) const;
    /// Expects a number whose magnitude is below a limit.
    void expect_below(const std::string& quantity, const std::string& unit, double ours, double limit,
                      TestLine at = TestLine::here()) const;
    /// Expects a number above a limit.
    void expect_above(const std::string& quantity, const std::string& unit, double ours, double limit,
                      TestLine at = TestLine::here()) const;
    /// Expects a word: the mode of failure, or whether something moves.
    void expect_outcome(const std::string& quantity, const std::string& ours, const std::string& expected,
                        TestLine at = TestLine::here()) const;
    /// Records a number and its reference without an assertion.
    void inform(const std::string& quantity, const std::string& unit, double ours, double reference) const;
    /// Records a number that has no reference.
    void inform(const std::string& quantity, const std::string& unit, double ours) const;
    /// Records a known miss with its reason. Fails if the number is within the tolerance, so that no miss is
    /// listed after its cause is gone.
    void expect_miss(const std::string& quantity, const std::string& unit, double ours, double expected,
                     const KnownMiss& miss, TestLine at = TestLine::here()) const;

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

/// Records curves that the report draws as one picture below the table of the case. The first curve is the
/// reference. @param slug identifies the picture of the case: letters, digits and dashes.
void record_picture(const std::string& id, const std::string& slug, const std::string& title,
                    const std::string& x_label, const std::string& y_label, const std::vector<Curve>& curves);

}  // namespace rockslope::verification
