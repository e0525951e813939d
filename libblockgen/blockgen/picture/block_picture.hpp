#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "blockgen/mesh/block_mesh.hpp"
#include "common/drawing/canvas.hpp"

namespace rockslope::blockgen {

/// Colours that replace the material colour of blocks, with their legend.
struct BlockLayer {
    struct Entry {
        std::string text;
        Colour colour;
    };
    std::string title;
    std::vector<Entry> entries;
    PerBlock<std::int32_t> entry_of_block;  ///< index into `entries`; -1: the material's colour
};

/// Draws the section: blocks filled by material, joints coloured by set, fixed, prescribed and excavated
/// blocks hatched, measured points, bolts and the water table; axes in metres, scale bar and legends.
Canvas draw_blocks(const BlockMesh& mesh, const BlockLayer& layer = {}, const PageStyle& style = {});

/// Draws the cumulative distribution of block areas, by area and by number, on a logarithmic scale, with D10,
/// D50 and D90 by area marked.
Canvas draw_sizes(const BlockMesh& mesh, const PageStyle& style = {});

}  // namespace rockslope::blockgen
