#pragma once

#include <cstddef>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/mesh/block_mesh.hpp"
#include "blockgen/report/cut_report.hpp"

namespace rockslope::blockgen {

struct CutOptions {
    std::size_t max_blocks = 1'000'000;
    bool verify = false;  ///< recut with exact construction and compare
};

struct CutResult {
    BlockMesh mesh;
    CutReport report;
};

/// Cuts a slope by joints into blocks. Joints that end in rock are cut back to the last block corner; an edge
/// between two materials separates blocks even without a joint. The blocks are numbered by their lowest-left
/// vertex, so they do not depend on the order of the joints. @throws InputError for a model that cannot be
/// cut, std::logic_error when a proof fails.
CutResult cut_blocks(const SlopeModel& model, const std::vector<Trace>& traces,
                     const CutOptions& options = {});

}  // namespace rockslope::blockgen
