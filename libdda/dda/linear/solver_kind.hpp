#pragma once

namespace dda {

/// Which factorisation solves a step's equations. Both are exact; CHOLMOD's is the reference to compare with.
enum class SolverKind { multifrontal, cholmod };

}  // namespace dda
