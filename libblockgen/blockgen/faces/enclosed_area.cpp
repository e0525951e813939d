#include "blockgen/faces/enclosed_area.hpp"

#include <algorithm>

#include "blockgen/arrangement/arrange.hpp"
#include "blockgen/faces/block_rings.hpp"

namespace rockslope::blockgen {

namespace {

/// The outer rings of the faces of one number, where each face has the number of `block`.
std::vector<Ring> rings_of(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces) {
    const BlockBoundary boundary(noded, subdivision, faces);
    std::vector<Ring> rings;
    std::vector<char> walked(boundary.next.size(), 0);
    for (std::size_t start = 0; start < boundary.next.size(); ++start) {
        const std::int32_t block = faces.block[static_cast<std::size_t>(subdivision.face[start])];
        if (!boundary.is_boundary[start / 2] || block == FaceBlocks::outside || walked[start]) continue;
        Ring ring;
        for (std::size_t h = start; !walked[h]; h = static_cast<std::size_t>(boundary.next[h])) {
            walked[h] = 1;
            ring.push_back(noded.frame.place(noded.vertices[static_cast<std::size_t>(boundary.origin[h])]));
        }
        if (twice_signed_area(ring) > 0) rings.push_back(std::move(ring));
    }
    return rings;
}

FaceBlocks numbered(const Subdivision& subdivision, bool apart) {
    FaceBlocks faces;
    faces.block.assign(static_cast<std::size_t>(subdivision.face_count), FaceBlocks::outside);
    for (std::int32_t f = 1; f < subdivision.face_count; ++f)
        faces.block[static_cast<std::size_t>(f)] = apart ? f - 1 : 0;
    return faces;
}

}  // namespace

EnclosedArea enclosed_area(std::span<const std::pair<Point, Point>> lines, std::span<const Point> points,
                           double step) {
    std::vector<SourceSegment> segments;
    for (const auto& [a, b] : lines) segments.push_back({a, b, static_cast<std::int32_t>(segments.size())});
    const NodedEdges noded = node_joints(segments, step);
    const Subdivision subdivision = arrange(noded);
    EnclosedArea area;
    area.outlines = rings_of(noded, subdivision, numbered(subdivision, false));
    const std::vector<Ring> faces = rings_of(noded, subdivision, numbered(subdivision, true));
    for (const Point& p : points) {
        // A face with another one in it holds its points too: the smallest is the innermost.
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
