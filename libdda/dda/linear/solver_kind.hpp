#pragma once

namespace rockslope::dda {

/// Which factorisation solves a step's equations. All are as exact; `refined` keeps its factor in single
/// precision whatever its size, and CHOLMOD's is the reference to compare with.
enum class SolverKind { multifrontal, refined, cholmod };

}  // namespace rockslope::dda
