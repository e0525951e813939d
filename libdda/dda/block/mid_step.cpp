#include "dda/block/mid_step.hpp"

namespace dda {

MidStep predict_mid_step(const Model& model, const BlockSystem& blocks, std::span<const Vec6> displacement) {
    const Topology& topology = model.topology;
    MidStep mid{blocks.vertices, blocks.points, {}};
    std::vector<BlockMap> maps;
    maps.reserve(displacement.size());
    for (std::size_t b = 0; b < displacement.size(); ++b) {
        maps.emplace_back(blocks.moments[b].centroid, displacement[b] / 2);
        mid.centroid.push_back(maps[b](blocks.moments[b].centroid));
        if (displacement[b].isZero(0)) continue;
        for (int k = topology.block_corners[b]; k < topology.block_corners[b + 1]; ++k) {
            Vec2& vertex = mid.vertices[static_cast<std::size_t>(k)];
            vertex = maps[b](vertex);
        }
    }
    for (std::size_t p = 0; p < mid.points.size(); ++p) {
        mid.points[p] = maps[static_cast<std::size_t>(model.material_points[p].block)](mid.points[p]);
    }
    return mid;
}

}  // namespace dda
