#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "blockgen/mesh/block_mesh.hpp"
#include "common/drawing/canvas.hpp"

namespace rockslope::blockgen {

/// Colours laid over blocks, with a legend of their own.
struct BlockLayer {
    struct Entry {
        std::string text;
        Colour colour;
    };
    std::string title;
    std::vector<Entry> entries;
    std::vector<std::int32_t> entry_of_block;  ///< -1 where the rock's own colour stays
};

/// The section on a page: blocks filled by material, joints coloured by set, fixed and prescribed blocks
/// hatched, measured points named, bolts drawn; axes in metres, scale bar and legends.
Canvas draw_blocks(const BlockMesh& mesh, const BlockLayer& layer = {});

}  // namespace rockslope::blockgen
