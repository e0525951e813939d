#pragma once

#include <cstddef>

#include "blockgen/mesh/block_mesh.hpp"
#include "common/base/thread_pool.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

/// A ring's vertices in order.
Ring ring_points(const BlockMesh& mesh, BlockIndex block, std::size_t ring);

/// Area of a block without its holes, m2.
double block_area(const BlockMesh& mesh, BlockIndex block);

/// Centroid of a block without its holes.
Point block_centroid(const BlockMesh& mesh, BlockIndex block);

/// Length of all rings of a block, holes included, m.
double block_perimeter(const BlockMesh& mesh, BlockIndex block);

/// 4 pi area / perimeter^2: 1 for a circle, 0.785 for a square, near 0 for a sliver.
double block_roundness(const BlockMesh& mesh, BlockIndex block);

/// Aspect ratio, in (0, 1]: the square root of the smaller over the larger principal second moment of area
/// about the centroid. It is 1 for a square or a circle.
double block_aspect(const BlockMesh& mesh, BlockIndex block);

/// The 10th, 50th and 90th percentiles over the blocks, by number.
struct Deciles {
    double p10 = 0, p50 = 0, p90 = 0;
};

/// Shapes of all blocks of a mesh.
struct ShapeSummary {
    Deciles roundness;
    Deciles aspect;
    double mean_corners = 0;  ///< of a block
};

ShapeSummary shape_summary(const BlockMesh& mesh, const ThreadPool& pool = ThreadPool());

/// Areas of blocks; zeros when there are none.
struct AreaSummary {
    double area = 0;           ///< of all blocks, m2
    double smallest_area = 0;  ///< m2
    double largest_area = 0;   ///< m2
    double d10 = 0;            ///< m2: blocks up to this area make up 10 % of the total area
    double d50 = 0;            ///< m2: blocks up to this area make up 50 %
    double d90 = 0;            ///< m2: blocks up to this area make up 90 %
};

/// The areas of all blocks, m2.
PerBlock<double> block_areas(const BlockMesh& mesh, const ThreadPool& pool = ThreadPool());

/// Summarises the areas of blocks.
AreaSummary area_summary(std::vector<double> areas, const ThreadPool& pool = ThreadPool());

/// The edges and corners of blocks; zeros when there are none.
struct CornerSummary {
    double smallest_edge = 0;   ///< m
    double smallest_angle = 0;  ///< rad, the sharpest corner of a block, in (0, pi)
};

/// Finds the smallest edge and angle of all blocks.
CornerSummary corner_summary(const BlockMesh& mesh, const ThreadPool& pool = ThreadPool());

}  // namespace rockslope::blockgen
