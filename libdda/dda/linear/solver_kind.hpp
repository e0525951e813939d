#pragma once

namespace rockslope::dda {

/// Which factorisation solves the equations of a step. All meet the same tolerance. `refined` uses a factor
/// in single precision at any size; `simplicial` is the reference to compare with.
enum class SolverKind { multifrontal, refined, simplicial };

}  // namespace rockslope::dda
