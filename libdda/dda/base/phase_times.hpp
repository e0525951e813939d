#pragma once

#include <array>
#include <cstddef>

namespace rockslope::dda {

/// The phases of a time step whose run time is measured.
enum class Phase {
    detection,      ///< candidate pairs and contacts
    transfer,       ///< contact states, forces and histories of the previous step
    preparation,    ///< springs, loads and all other terms that are constant during the iteration
    analysis,       ///< symbolic analysis of a new matrix pattern
    assembly,       ///< assembly of the matrix
    factorisation,  ///< numerical factorisation
    solution,       ///< right-hand sides, back-substitutions and friction coupling
    evaluation,     ///< evaluation of contacts, with the line search
    update,         ///< new state, energies, and the search for undetected penetrations
    count
};

/// Sums the run time of each phase over many steps. The caller supplies the clock. Only benchmarks use it.
class PhaseTimes {
  public:
    using Clock = double (*)();  ///< s

    explicit PhaseTimes(Clock clock) : clock_(clock), last_(clock()) {}

    /// Restarts the clock; the time before this call counts for no phase.
    void start() { last_ = clock_(); }
    /// Adds the time since the last call to that phase.
    void end_of(Phase phase) {
        const double now = clock_();
        seconds_[static_cast<std::size_t>(phase)] += now - last_;
        last_ = now;
    }
    /// The time spent in a phase, s.
    double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }
    /// Sets all times to zero.
    void clear() { seconds_ = {}; }

  private:
    Clock clock_;
    double last_;
    std::array<double, static_cast<std::size_t>(Phase::count)> seconds_{};
};

/// Ends a phase; does nothing if `times` is null.
inline void end_of(Phase phase, PhaseTimes* times) {
    if (times != nullptr) times->end_of(phase);
}

}  // namespace rockslope::dda
