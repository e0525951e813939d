#pragma once

#include "blockgen/noding/indices.hpp"

namespace rockslope::blockgen {

/// A half-edge of a subdivision: one of the two sides of an edge.
using HalfEdgeIndex = Index<struct HalfEdgeKind>;
/// A face of a subdivision.
using FaceIndex = Index<struct FaceKind>;

template <class T>
using PerHalfEdge = IndexedVector<HalfEdgeIndex, T>;
template <class T>
using PerFace = IndexedVector<FaceIndex, T>;

/// The half-edge from the first to the second vertex of an edge.
constexpr HalfEdgeIndex forward_half(EdgeIndex edge) {
    return 2 * edge.value();
}
/// The half-edge from the second to the first vertex of an edge.
constexpr HalfEdgeIndex backward_half(EdgeIndex edge) {
    return 2 * edge.value() + 1;
}
constexpr EdgeIndex edge_of(HalfEdgeIndex half_edge) {
    return half_edge.value() / 2;
}
constexpr bool is_forward(HalfEdgeIndex half_edge) {
    return half_edge.value() % 2 == 0;
}
/// The other half-edge of the same edge.
constexpr HalfEdgeIndex twin(HalfEdgeIndex half_edge) {
    return half_edge.value() ^ 1;
}

}  // namespace rockslope::blockgen
