#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dda/analysis/energy.hpp"

namespace rockslope::scene {

/// Monitors the energy ledger from a start, step by step.
class EnergyMonitor {
  public:
    explicit EnergyMonitor(const dda::Energy& start)
        : start_(start),
          last_(start),
          exchanged_(1e-6 * (start.kinetic + start.strain + start.contact + start.constraint)) {}

    void observe(const dda::Energy& now) {
        const std::array<double, 12> changes = {now.kinetic,
                                                now.strain - start_.strain,
                                                now.contact - start_.contact,
                                                now.constraint - start_.constraint,
                                                now.gravity - start_.gravity,
                                                now.friction_loss - start_.friction_loss,
                                                now.damping_loss - start_.damping_loss,
                                                now.contact_damping_loss - start_.contact_damping_loss,
                                                now.numerical_loss - start_.numerical_loss,
                                                now.released - start_.released,
                                                now.boundary_loss - start_.boundary_loss,
                                                now.external_work - start_.external_work};
        for (const double change : changes) exchanged_ = std::max(exchanged_, std::abs(change));
        residual_ = std::max(residual_, std::abs(now.residual() - start_.residual()));
        least_friction_ = std::min(least_friction_, now.friction_loss - last_.friction_loss);
        last_ = now;
    }
    /// Energy exchanged since the start, J: the largest of the kinetic energy and of the changes of all other
    /// accounts, at least a millionth of the energy stored at the start, since less is rounding. It is not
    /// summed over the cycles of a vibration, which would make errors relative to it look small.
    double exchanged() const { return exchanged_; }
    /// Largest residual of the ledger, over the energy exchanged.
    double residual() const { return fraction(residual_); }
    /// Smallest work of friction in a step, over the energy exchanged.
    double least_friction() const { return fraction(least_friction_); }
    /// Loss by the time integration since the start, over the energy exchanged.
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
