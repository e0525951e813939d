#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "blockgen/faces/classify_faces.hpp"

namespace rockslope::blockgen {

/// Where the length of the joints of one set, or of traces of one name, went, m, and how densely they lie in
/// the rock. Overlapping joints each count.
struct JointBalance {
    std::string name;
    std::size_t traces = 0;
    double input = 0;        ///< as read or sampled; equals the next four together but for snapping
    double retained = 0;     ///< between two blocks
    double pruned = 0;       ///< ends in rock, encloses nothing, or lies within merged blocks
    double on_boundary = 0;  ///< along the outline, a hole or a tunnel, where the free face wins
    double outside = 0;      ///< beyond the rock
    double p10 = 0;         ///< 1/m: joints met by a line across the set's mean direction, or the traces' own
    double p20 = 0;         ///< 1/m2: traces, each counted at its middle
    double p21 = 0;         ///< m/m2: length in rock, retained and pruned, per area
    double p10_target = 0;  ///< 1/m; 0 when nobody asked, here and below
    double p20_target = 0;  ///< 1/m2
    double p21_target = 0;  ///< m/m2
    double count_target = 0;
};

/// Nodes of the joints inside the rock by the number of branches that meet there (Sanderson and Nixon 2015):
/// tips, abutments and crossings. What ends at a free face is an edge node.
struct NodeCounts {
    std::size_t i = 0, y = 0, x = 0, edge = 0;
};

struct NetworkReport {
    std::vector<JointBalance> joints;  ///< in the order of the traces
    NodeCounts nodes;
    std::vector<std::string> warnings;  ///< given traces that make nothing, counted by name
};

/// Measures joints after noding. Densities are those of all rock, or of the rock in the region of a set that
/// has one. What is asked for follows from stop rule, spacing and persistence. @param rock_area m2. @throws
/// std::logic_error when a joint's length does not add up within what snapping may move.
NetworkReport measure_network(const NodedEdges& noded, const Subdivision& subdivision,
                              const FaceBlocks& faces, const SlopeModel& model,
                              const std::vector<Trace>& traces, const SourceTable& table, double rock_area);

}  // namespace rockslope::blockgen
