#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "blockgen/mesh/measures.hpp"
#include "blockgen/report/changes.hpp"
#include "blockgen/report/joint_balance.hpp"
#include "blockgen/report/kinematics.hpp"

namespace rockslope::blockgen {

/// Rock that a stage of the run takes out.
struct ExcavationReport {
    std::string name;
    int stage = 1;
    std::size_t blocks = 0;
    double area = 0;  ///< m2
};

/// What cutting did, for the user.
struct CutReport {
    std::size_t blocks = 0;
    std::size_t holes = 0;           ///< inner rings of blocks
    std::size_t islands = 0;         ///< groups of blocks enclosed by one block
    std::size_t interior_edges = 0;  ///< shared by two blocks
    std::size_t boundary_edges = 0;
    std::size_t slivers = 0;      ///< blocks whose roundness is below the wanted one, 0.02 by default
    std::size_t island_cuts = 0;  ///< joints added to lead islands to the rim
    MergeReport merges;
    std::vector<Change>
        changes;  ///< made by cleaning, those of `merges` among them; sorted by kind and place
    std::size_t merged_vertices = 0;  ///< on straight edges where no third edge ends
    int noding_rounds = 0;
    double largest_snap = 0;   ///< m, upper bound
    double domain_area = 0;    ///< m2, of the rock after snapping, from its outline
    bool area_proved = false;  ///< the blocks' areas sum up to it as integers
    bool verified = false;     ///< an arrangement with exact construction agreed
    std::vector<ExcavationReport> excavations;
    SizeSummary sizes;
    ShapeSummary shapes;
    std::vector<JointBalance> joints;  ///< in the order of the model: traces, then sets
    NodeCounts nodes;
    std::optional<KinematicReport> kinematics;  ///< when the model asks for it
    std::vector<std::string> warnings;
};

/// The report as JSON, ready to be written.
std::string report_text(const CutReport& report);
/// The same as tables to be read.
std::string report_tables(const CutReport& report);
/// A block's mode in a word or three.
const char* label_of(BlockMode mode);

}  // namespace rockslope::blockgen
