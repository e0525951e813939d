#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "blockgen/arrangement/prove_noding.hpp"
#include "blockgen/input/slope_model.hpp"
#include "blockgen/mesh/block_mesh.hpp"
#include "blockgen/report/cut_report.hpp"

namespace rockslope::blockgen {

struct CutOptions {
    std::size_t max_blocks = 1'000'000;
    bool verify = false;  ///< prove the noding and the arrangement by exact construction
    std::size_t most_proved = most_proved_segments;  ///< beyond it only the arrangement is proved
    int threads = 1;                                 ///< the result does not depend on their number
    /// Whether the report has the balance of the joints and their densities, the log of changes, and the
    /// shapes and corners of the blocks, which take a third of the time.
    bool full_report = true;
    /// Called with the name of each phase when it is done, to measure time and memory.
    std::function<void(const char* phase)> on_phase = {};
};

struct CutResult {
    BlockMesh mesh;
    CutReport report;
};

/// Cuts a slope by joints into blocks. Dangling ends of joints are pruned back to the last block corner; an
/// edge between two materials separates blocks even without a joint. Blocks are numbered in the order of
/// their smallest vertex, by x and then y, so that their numbers do not depend on the order of the joints.
/// @throws InputError for a model that cannot be cut, std::logic_error when a check of the result fails.
CutResult cut_blocks(const SlopeModel& model, const std::vector<Trace>& traces,
                     const CutOptions& options = {});

}  // namespace rockslope::blockgen
