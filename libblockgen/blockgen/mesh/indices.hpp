#pragma once

#include "common/base/index.hpp"

namespace rockslope::blockgen {

/// A block of a BlockMesh.
using BlockIndex = Index<struct MeshBlockKind>;
/// A ring among those of all blocks.
using RingIndex = Index<struct MeshRingKind>;
/// A corner of a ring, among the corners of all rings. The edge that begins there has the same index.
using CornerIndex = Index<struct MeshCornerKind>;
/// A vertex of a BlockMesh; blocks that touch share it.
using VertexIndex = Index<struct MeshVertexKind>;
using BlockMaterialIndex = Index<struct MeshBlockMaterialKind>;
using JointMaterialIndex = Index<struct MeshJointMaterialKind>;
/// A joint of a BlockMesh.
using JointIndex = Index<struct MeshJointKind>;

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
