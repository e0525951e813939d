#include "dda/block/mid_step.hpp"

namespace rockslope::dda {

MidStep predict_mid_step(const Model& model, const BlockSystem& blocks, BlockSpan<const Vec6> displacement,
                         const ThreadPool& pool) {
    const Topology& topology = model.topology;
    MidStep mid{blocks.vertices, blocks.points, PerBlock<Vec2>(displacement.size())};
    const auto map_of = [&](BlockIndex b) {
        return BlockMap(blocks.moments[b].centroid, displacement[b] / 2);
    };
    pool.parallel_for(displacement.size(), [&](std::size_t begin, std::size_t end) {
        for (const BlockIndex b : indices<BlockIndex>(begin, end)) {
            const BlockMap map = map_of(b);
            mid.centroid[b] = map(blocks.moments[b].centroid);
            if (displacement[b].isZero(0)) continue;
            for (const CornerIndex k : topology.corners_of(b)) mid.vertices[k] = map(mid.vertices[k]);
        }
    });
    for (const PointIndex p : mid.points.indices())
        mid.points[p] = map_of(model.material_points[p].block)(mid.points[p]);
    return mid;
}

}  // namespace rockslope::dda
