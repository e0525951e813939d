#include "blockgen/faces/enclosed_area.hpp"

#include <algorithm>

#include "blockgen/arrangement/arrange.hpp"
#include "blockgen/faces/block_rings.hpp"

namespace rockslope::blockgen {

namespace {

/// The outer rings of groups of faces; the group of face f is faces.block[f].
std::vector<Ring> rings_of(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces) {
    const BlockBoundary boundary(noded, subdivision, faces);
    std::vector<Ring> rings;
    PerHalfEdge<char> walked(boundary.half_edge_count(), 0);
    for (const HalfEdgeIndex start : boundary.half_edges()) {
        const FaceBlockIndex block = faces.block[subdivision.face[start]];
        if (!boundary.is_boundary[edge_of(start)] || block == FaceBlocks::outside || walked[start]) continue;
        Ring ring;
        for (HalfEdgeIndex h = start; !walked[h]; h = boundary.next(h)) {
            walked[h] = 1;
            const NodeIndex vertex = boundary.origin(h);
            ring.push_back(noded.frame.position(noded.vertices[vertex]));
        }
        if (twice_signed_area(ring) > 0) rings.push_back(std::move(ring));
    }
    return rings;
}

/// All bounded faces in one group, or each in a group of its own.
FaceBlocks grouped_faces(const Subdivision& subdivision, bool one_group) {
    FaceBlocks faces;
    faces.block.assign(subdivision.face_count, FaceBlocks::outside);
    for (const FaceIndex f : indices<FaceIndex>(1, subdivision.face_count))
        faces.block[f] = one_group ? 0 : f.value() - 1;
    return faces;
}

}  // namespace

EnclosedArea enclosed_area(std::span<const std::pair<Point, Point>> lines, std::span<const Point> points,
                           double step) {
    std::vector<SourceSegment> segments;
    for (const auto& [a, b] : lines) segments.push_back({a, b, segments.size()});
    const NodedEdges noded = node_joints(segments, step);
    const Subdivision subdivision = arrange(noded);
    EnclosedArea area;
    area.outlines = rings_of(noded, subdivision, grouped_faces(subdivision, true));
    const std::vector<Ring> faces = rings_of(noded, subdivision, grouped_faces(subdivision, false));
    for (const Point& p : points) {
        // The outer ring of a face also contains the faces in its holes; the smallest ring is the innermost.
        const Ring* smallest = nullptr;
        for (const Ring& face : faces)
            if (side_of_ring(face, p) > 0 &&
                (smallest == nullptr || twice_signed_area(face) < twice_signed_area(*smallest)))
                smallest = &face;
        area.faces.push_back(smallest == nullptr ? std::nullopt : std::optional(*smallest));
    }
    return area;
}

}  // namespace rockslope::blockgen
