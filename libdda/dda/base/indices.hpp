#pragma once

#include "common/base/index.hpp"

namespace rockslope::dda {

using BlockIndex = Index<struct BlockKind>;
using RingIndex = Index<struct RingKind>;
using CornerIndex = Index<struct CornerKind>;
/// An edge has the number of its first corner.
using EdgeIndex = Index<struct EdgeKind>;
using ContactIndex = Index<struct ContactIndexKind>;
/// A row of the linear system: the six unknowns of one free block.
using RowIndex = Index<struct RowKind>;
using PointIndex = Index<struct MaterialPointKind>;
using JointIndex = Index<struct JointKind>;
using BlockMaterialIndex = Index<struct BlockMaterialKind>;
using JointMaterialIndex = Index<struct JointMaterialKind>;

/// The corner at which an edge starts; both have the same number.
constexpr CornerIndex start_of(EdgeIndex edge) {
    return edge.value();
}
/// The edge that begins at a corner.
constexpr EdgeIndex edge_from(CornerIndex corner) {
    return corner.value();
}

template <class T>
using PerBlock = IndexedVector<BlockIndex, T>;
template <class T>
using PerCorner = IndexedVector<CornerIndex, T>;
template <class T>
using PerEdge = IndexedVector<EdgeIndex, T>;
template <class T>
using PerContact = IndexedVector<ContactIndex, T>;
template <class T>
using PerRow = IndexedVector<RowIndex, T>;
template <class T>
using PerPoint = IndexedVector<PointIndex, T>;

template <class T>
using BlockSpan = IndexedSpan<BlockIndex, T>;
template <class T>
using CornerSpan = IndexedSpan<CornerIndex, T>;
template <class T>
using ContactSpan = IndexedSpan<ContactIndex, T>;
template <class T>
using RowSpan = IndexedSpan<RowIndex, T>;

}  // namespace rockslope::dda
