#include "dda/trial/trial_bolts.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

TrialBolts::TrialBolts(const StepProblem& problem)
    : p_(problem), yielding_(p_.bolts.size()), elongation_(p_.bolts.size()), linear_(p_.bolts.size()) {}

double TrialBolts::linear_force(std::size_t bolt, double elongation) const {
    return is_elastic(bolt) ? elastic_force(bolt, elongation)
                            : yielding_[bolt] * p_.model.bolts[bolt].yield_force;
}

/// The bolt's force, Eq. (38).
double TrialBolts::law_force(std::size_t bolt, double elongation) const {
    const double elastic = elastic_force(bolt, elongation);
    const double yield = p_.model.bolts[bolt].yield_force;
    return yield > 0 ? std::clamp(elastic, -yield, yield) : elastic;
}

void TrialBolts::set_target(RowSpan<const Vec6> target) {
    for (std::size_t k = 0; k < linear_.size(); ++k) {
        const BoltSpring& bolt = p_.bolts[k];
        linear_[k] = linear_force(k, bolt.rows.measure(bolt.elongation, target));
    }
}

void TrialBolts::move_to(RowSpan<const Vec6> d) {
    for (std::size_t k = 0; k < elongation_.size(); ++k) {
        const BoltSpring& bolt = p_.bolts[k];
        elongation_[k] = bolt.rows.measure(bolt.elongation, d);
    }
}

double TrialBolts::force_change() const {
    double largest = 0;
    for (std::size_t k = 0; k < linear_.size(); ++k)
        largest = std::max(largest, std::abs(force(k) - linear_[k]));
    return largest;
}

bool TrialBolts::update_active_set() {
    bool changed = false;
    for (std::size_t k = 0; k < yielding_.size(); ++k) {
        const double elastic = elastic_force(k, elongation_[k]);
        const double law = force(k);
        const int yielding = elastic == law ? 0 : (elastic > law ? 1 : -1);
        changed = changed || yielding != yielding_[k];
        yielding_[k] = yielding;
    }
    return changed;
}

}  // namespace rockslope::dda
