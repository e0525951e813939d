#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "blockgen/arrangement/prove_noding.hpp"
#include "blockgen/mesh/measures.hpp"
#include "blockgen/report/changes.hpp"
#include "blockgen/report/joint_balance.hpp"
#include "blockgen/report/joint_planes.hpp"
#include "blockgen/report/kinematics.hpp"
#include "blockgen/report/scanlines.hpp"
#include "blockgen/report/topology.hpp"

namespace rockslope::blockgen {

/// Rock removed at the start of a stage of the simulation.
struct ExcavationReport {
    std::string name;
    int stage = 1;
    std::size_t blocks = 0;
    double area = 0;  ///< m2
};

/// Results and statistics of a cut.
struct CutReport {
    std::size_t blocks = 0;
    std::size_t holes = 0;           ///< inner rings of blocks
    std::size_t islands = 0;         ///< groups of blocks enclosed by one block
    std::size_t interior_edges = 0;  ///< shared by two blocks
    std::size_t boundary_edges = 0;
    std::size_t slivers = 0;      ///< blocks with a roundness below small_blocks.below_roundness
    std::size_t island_cuts = 0;  ///< joints added to connect islands to the block around them
    MergeReport merges;
    std::vector<Change> changes;  ///< all changes, including those of `merges`; sorted by kind and position
    std::size_t merged_vertices = 0;  ///< vertices removed from straight edges
    int noding_rounds = 0;
    double largest_snap = 0;            ///< m, upper bound
    double domain_area = 0;             ///< m2, of the rock after snapping, from its outline
    bool area_proved = false;           ///< the areas of the blocks sum to domain_area in exact integers
    bool verified = false;              ///< an arrangement with exact construction has the same faces
    std::optional<NodingProof> noding;  ///< proof of the noding, where it was asked for and made
    std::vector<ExcavationReport> excavations;
    AreaSummary sizes;
    AreaSummary free_sizes;  ///< of the blocks that are neither fixed nor prescribed
    CornerSummary corners;
    ShapeSummary shapes;
    std::vector<JointBalance> joints;             ///< in the order of the model: traces, then sets
    std::vector<JointPlanes> planes;              ///< of the sets that are given by planes in space
    std::optional<DensestPlanes> densest_planes;  ///< present if there are such planes
    Topology topology;
    std::vector<ScanlineCount> scanlines;
    TraceEnds trace_ends;
    std::optional<KinematicReport> kinematics;  ///< present if the model has [kinematics]
    std::vector<std::string> warnings;
};

/// The report as JSON text.
std::string report_text(const CutReport& report);
/// The report as plain-text tables.
std::string report_tables(const CutReport& report);
/// Name of a mode in the report.
const char* label_of(BlockMode mode);

}  // namespace rockslope::blockgen
