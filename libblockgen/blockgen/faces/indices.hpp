#pragma once

#include "common/base/index.hpp"

namespace rockslope::blockgen {

/// A block as a set of faces. The blocks of a BlockMesh are the same ones, sorted and numbered anew.
using FaceBlockIndex = Index<struct FaceBlockKind>;
/// The rock of a face: 0 the domain's, k that of region k, counted from 1.
using RockIndex = Index<struct RockKind>;
/// An excavation of the slope model.
using ExcavationIndex = Index<struct ExcavationKind>;
/// A joint trace that the cutter is given.
using JointTraceIndex = Index<struct JointTraceKind>;

template <class T>
using PerFaceBlock = IndexedVector<FaceBlockIndex, T>;
template <class T>
using PerJointTrace = IndexedVector<JointTraceIndex, T>;

}  // namespace rockslope::blockgen
