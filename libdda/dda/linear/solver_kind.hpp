#pragma once

namespace rockslope::dda {

/// Which factorisation solves the equations of a step. All meet the same tolerance. `refined` uses a factor
/// in single precision at any size; `cholmod` is the reference to compare with.
enum class SolverKind { multifrontal, refined, cholmod };

}  // namespace rockslope::dda
