#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dda/analysis/energy.hpp"

namespace rockslope::scene {

/// Follows the energy ledger from one instant on, step by step.
class EnergyMonitor {
  public:
    explicit EnergyMonitor(const dda::Energy& start)
        : start_(start),
          last_(start),
          exchanged_(1e-6 * (start.kinetic + start.strain + start.contact + start.constraint)) {}

    void observe(const dda::Energy& now) {
        const std::array<double, 11> changes = {now.kinetic,
                                                now.strain - start_.strain,
                                                now.contact - start_.contact,
                                                now.constraint - start_.constraint,
                                                now.gravity - start_.gravity,
                                                now.friction_loss - start_.friction_loss,
                                                now.damping_loss - start_.damping_loss,
                                                now.numerical_loss - start_.numerical_loss,
                                                now.released - start_.released,
                                                now.boundary_loss - start_.boundary_loss,
                                                now.external_work - start_.external_work};
        for (const double change : changes) exchanged_ = std::max(exchanged_, std::abs(change));
        residual_ = std::max(residual_, std::abs(now.residual() - start_.residual()));
        least_friction_ = std::min(least_friction_, now.friction_loss - last_.friction_loss);
        last_ = now;
    }
    /// The largest kinetic energy, or the largest change of any other account since the start, J: no sum over
    /// the swings of a vibration, so that shares of it are not flattered. Where less than a millionth of what
    /// was stored is exchanged, that millionth: the rest is rounding.
    double exchanged() const { return exchanged_; }
    /// What the ledger left unexplained at the worst instant, over the energy exchanged.
    double residual() const { return fraction(residual_); }
    /// What friction took in the step in which it took least, over the energy exchanged.
    double least_friction() const { return fraction(least_friction_); }
    /// Taken by the time integration since the start, over the energy exchanged.
    double integration_loss() const { return fraction(last_.numerical_loss - start_.numerical_loss); }

  private:
    double fraction(double energy) const { return exchanged_ > 0 ? energy / exchanged_ : 0; }

    dda::Energy start_;
    dda::Energy last_;
    double exchanged_;
    double residual_ = 0;
    double least_friction_ = std::numeric_limits<double>::infinity();
};

}  // namespace rockslope::scene
