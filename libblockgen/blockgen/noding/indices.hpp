#pragma once

#include "common/base/index.hpp"

namespace rockslope::blockgen {

/// A vertex of the noded network. The vertices of a BlockMesh are a selection of them, numbered anew.
using NodeIndex = Index<struct NodeKind>;
/// An edge of a network.
using EdgeIndex = Index<struct NetworkEdgeKind>;
/// A line that a round of snap rounding takes in.
using SegmentIndex = Index<struct SegmentKind>;
/// A hot cell of a round of snap rounding.
using CellIndex = Index<struct CellKind>;
/// A joint trace or an outline, by the caller's number.
using SourceIndex = Index<struct SourceKind>;

template <class T>
using PerNode = IndexedVector<NodeIndex, T>;
template <class T>
using PerEdge = IndexedVector<EdgeIndex, T>;
template <class T>
using PerSegment = IndexedVector<SegmentIndex, T>;
template <class T>
using PerCell = IndexedVector<CellIndex, T>;

template <class T>
using NodeSpan = IndexedSpan<NodeIndex, T>;
template <class T>
using EdgeSpan = IndexedSpan<EdgeIndex, T>;
template <class T>
using SegmentSpan = IndexedSpan<SegmentIndex, T>;
template <class T>
using CellSpan = IndexedSpan<CellIndex, T>;

}  // namespace rockslope::blockgen
