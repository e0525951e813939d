#include "dda/analysis/unexpected_turn.hpp"

#include <algorithm>
#include <cmath>

namespace dda {

namespace {

/// A mistake in the rotation over the step, times the rotation, rad2, from which on the work of contact
/// forces is looked at.
constexpr double noticed_turn = 1e-6;
/// The share of the kinetic energy by which that work may differ from what the springs store.
constexpr double noticed_work = 1e-6;

}  // namespace

bool turned_unexpectedly(std::span<const Vec6> predicted, std::span<const Vec6> displacement,
                         std::span<const ContactSprings> springs, std::span<const Contact> before,
                         const OpenCloseResult& result, double kinetic) {
    double turn = 0;
    for (std::size_t b = 0; b < displacement.size(); ++b)
        turn = std::max(turn, std::abs(displacement[b][2] * (displacement[b][2] - predicted[b][2])));
    if (turn < noticed_turn) return false;
    double work = 0;
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const JudgedContact& judged = result.contacts[k];
        const double linear = springs[k].rows.measure(springs[k].normal, result.displacement);
        work += std::abs(judged.normal_force * (judged.gap + judged.dilating - before[k].gap - linear));
    }
    return work > noticed_work * kinetic;
}

}  // namespace dda
