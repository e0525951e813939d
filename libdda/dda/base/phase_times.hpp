#pragma once

#include <array>
#include <cstddef>

namespace rockslope::dda {

/// What a step spends its time on.
enum class Phase {
    detection,      ///< candidates and contacts
    transfer,       ///< of states and histories from the contacts of the step before
    preparation,    ///< springs, loads, everything that is the same for all iterations
    analysis,       ///< ordering and planning of a new pattern
    assembly,       ///< of the matrix
    factorisation,  //
    solution,       ///< right-hand sides and back-substitutions
    evaluation,     ///< of contacts, with the line search
    update,         ///< of the state, energies, and the search for undetected_penetrations
    count
};

/// Adds up what the phases of steps take, by a clock of the caller's. Nothing but a benchmark has one.
class PhaseTimes {
  public:
    using Clock = double (*)();  ///< s

    explicit PhaseTimes(Clock clock) : clock_(clock), last_(clock()) {}

    /// What follows does not belong to what came before.
    void start() { last_ = clock_(); }
    /// The time since the last call belongs to that phase.
    void end_of(Phase phase) {
        const double now = clock_();
        seconds_[static_cast<std::size_t>(phase)] += now - last_;
        last_ = now;
    }
    double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }
    void clear() { seconds_ = {}; }

  private:
    Clock clock_;
    double last_;
    std::array<double, static_cast<std::size_t>(Phase::count)> seconds_{};
};

/// Where there may be no one who wants to know.
inline void end_of(Phase phase, PhaseTimes* times) {
    if (times != nullptr) times->end_of(phase);
}

}  // namespace rockslope::dda
