#pragma once

#include "common/base/index.hpp"

namespace rockslope::blockgen {

/// A block of a BlockMesh.
using BlockIndex = Index<struct BlockKind>;
/// A ring among those of all blocks.
using RingIndex = Index<struct RingKind>;
/// A corner of a ring, among the corners of all rings. The edge that begins there has the same index.
using CornerIndex = Index<struct CornerKind>;
/// A vertex of a BlockMesh; blocks that touch share it.
using VertexIndex = Index<struct VertexKind>;
using BlockMaterialIndex = Index<struct BlockMaterialKind>;
using JointMaterialIndex = Index<struct JointMaterialKind>;
/// A joint of a BlockMesh.
using JointIndex = Index<struct JointKind>;

template <class T>
using PerBlock = IndexedVector<BlockIndex, T>;
template <class T>
using PerRing = IndexedVector<RingIndex, T>;
template <class T>
using PerCorner = IndexedVector<CornerIndex, T>;
template <class T>
using PerVertex = IndexedVector<VertexIndex, T>;
template <class T>
using PerBlockMaterial = IndexedVector<BlockMaterialIndex, T>;
template <class T>
using PerJointMaterial = IndexedVector<JointMaterialIndex, T>;
template <class T>
using PerJoint = IndexedVector<JointIndex, T>;

}  // namespace rockslope::blockgen
