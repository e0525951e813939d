#include "dda/block/mid_step.hpp"

namespace rockslope::dda {

MidStep predict_mid_step(const Model& model, const BlockSystem& blocks, std::span<const Vec6> displacement,
                         const ThreadPool& pool) {
    const Topology& topology = model.topology;
    MidStep mid{blocks.vertices, blocks.points, std::vector<Vec2>(displacement.size())};
    const auto map_of = [&](std::size_t b) {
        return BlockMap(blocks.moments[b].centroid, displacement[b] / 2);
    };
    pool.parallel_for(displacement.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            const BlockMap map = map_of(b);
            mid.centroid[b] = map(blocks.moments[b].centroid);
            if (displacement[b].isZero(0)) continue;
            for (int k = topology.block_corners[b]; k < topology.block_corners[b + 1]; ++k) {
                Vec2& vertex = mid.vertices[static_cast<std::size_t>(k)];
                vertex = map(vertex);
            }
        }
    });
    for (std::size_t p = 0; p < mid.points.size(); ++p)
        mid.points[p] = map_of(static_cast<std::size_t>(model.material_points[p].block))(mid.points[p]);
    return mid;
}

}  // namespace rockslope::dda
