#include "dda/block/block_system.hpp"

#include <cmath>
#include <limits>

namespace rockslope::dda {

namespace {

/// Area moments of one block.
AreaMoments moments_of(const Topology& topology, const PerCorner<Vec2>& vertices, BlockIndex block) {
    const auto chunk = [block](const auto& of, const auto& ends, std::size_t more) {
        return std::span(of).subspan(ends[block], ends[block + 1] - ends[block] + more);
    };
    return integrate(chunk(vertices, topology.block_corners, 0),
                     chunk(topology.ring_corners, topology.block_rings, 1));
}

/// exp of a symmetric plane tensor (xx, yy, engineering xy), E of Eq. (8).
Eigen::Matrix2d exponential(const Vec3& strain) {
    const double mean = (strain[0] + strain[1]) / 2;
    const double half_difference = (strain[0] - strain[1]) / 2;
    const double half_shear = strain[2] / 2;
    const double radius = std::hypot(half_difference, half_shear);
    const double slope = radius > 1e-4 ? std::sinh(radius) / radius : 1 + radius * radius / 6;
    Eigen::Matrix2d deviator;
    deviator << half_difference, half_shear, half_shear, -half_difference;
    return std::exp(mean) * (std::cosh(radius) * Eigen::Matrix2d::Identity() + slope * deviator);
}

}  // namespace

BlockSystem initial_block_system(const Model& model) {
    const std::size_t count = model.block_count();
    BlockSystem blocks;
    blocks.vertices = model.vertices;
    for (const MaterialPoint& point : model.material_points) blocks.points.push_back(point.position);
    for (const BlockIndex b : model.blocks()) {
        const BlockMaterial& material = model.material_of(b);
        blocks.moments.push_back(moments_of(model.topology, model.vertices, b));
        // The mass stays constant, Eq. (6).
        blocks.mass.push_back(material.density * blocks.moments.back().area);
        blocks.stress.push_back(material.initial_stress);
    }
    blocks.rotation.assign(count, 0);
    blocks.velocity = model.initial_velocity;
    blocks.velocity.resize(count, Vec6::Zero());
    blocks.acceleration.assign(count, Vec6::Zero());
    return blocks;
}

BlockMap::BlockMap(const Vec2& block_centroid, const Vec6& displacement)
    : centroid(block_centroid), translation(displacement[0], displacement[1]) {
    const double c = std::cos(displacement[2]);
    const double s = std::sin(displacement[2]);
    Eigen::Matrix2d turn;
    // R of Eq. (7).
    turn << c, -s, s, c;
    gradient = turn * exponential(displacement.tail<3>());
}

double largest_displacement(const BlockSystem& blocks, const Topology& topology,
                            BlockSpan<const Vec6> displacement, const ThreadPool& pool) {
    const auto largest_square = [&](std::size_t begin, std::size_t end) {
        double square = 0;
        for (const BlockIndex b : indices<BlockIndex>(begin, end)) {
            if (!displacement[b].allFinite()) return std::numeric_limits<double>::infinity();
            for (const CornerIndex k : topology.corners_of(b)) {
                const Vec2 arm = blocks.vertices[k] - blocks.moments[b].centroid;
                square = std::max(square, displacement_at(arm, displacement[b]).squaredNorm());
            }
        }
        return square;
    };
    return std::sqrt(pool.parallel_reduce(displacement.size(), 0.0, largest_square,
                                          [](double a, double b) { return std::max(a, b); }));
}

Vec3 rotate_tensor(const Vec3& tensor, double angle, bool engineering) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double xy = engineering ? tensor[2] / 2 : tensor[2];
    const double turned_xy = c * s * (tensor[0] - tensor[1]) + (c * c - s * s) * xy;
    return {c * c * tensor[0] + s * s * tensor[1] - 2 * c * s * xy,
            s * s * tensor[0] + c * c * tensor[1] + 2 * c * s * xy, engineering ? 2 * turned_xy : turned_xy};
}

void move_blocks(const Model& model, BlockSpan<const Vec6> displacement, const ThreadPool& pool,
                 BlockSystem& blocks) {
    const Topology& topology = model.topology;
    for (const PointIndex p : blocks.points.indices()) {
        const BlockIndex b = model.material_points[p].block;
        blocks.points[p] = BlockMap(blocks.moments[b].centroid, displacement[b])(blocks.points[p]);
    }
    const auto move = [&](BlockIndex b) {
        const Vec6& d = displacement[b];
        if (d.isZero(0)) return;
        const BlockMap map(blocks.moments[b].centroid, d);
        for (const CornerIndex k : topology.corners_of(b)) blocks.vertices[k] = map(blocks.vertices[k]);
        blocks.moments[b] = moments_of(topology, blocks.vertices, b);
        blocks.rotation[b] += d[2];
        // Eq. (10): the stress gains its increment in the old axes, then turns with the block.
        const Vec3 stress = blocks.stress[b] + elasticity(model.material_of(b), model.plane) * d.tail<3>();
        blocks.stress[b] = rotate_tensor(stress, d[2], false);
        blocks.velocity[b].tail<3>() = rotate_tensor(blocks.velocity[b].tail<3>(), d[2], true);
        blocks.acceleration[b].tail<3>() = rotate_tensor(blocks.acceleration[b].tail<3>(), d[2], true);
    };
    pool.parallel_for(displacement.size(), [&](std::size_t begin, std::size_t end) {
        for (const BlockIndex b : indices<BlockIndex>(begin, end)) move(b);
    });
}

}  // namespace rockslope::dda
