#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "blockgen/faces/cut_context.hpp"

namespace rockslope::blockgen {

/// Balance of the trace length, m, and the density of the joints of one set or of traces of one name. Where
/// joints overlap in the rock the first in the order of the traces counts, as it names the edge.
struct JointBalance {
    std::string name;
    std::size_t traces = 0;
    double input = 0;        ///< as read or sampled; the sum of the next five, except for snapping
    double retained = 0;     ///< between two blocks
    double pruned = 0;       ///< same block on both sides: dangling, isolated, or within merged blocks
    double on_boundary = 0;  ///< along the outline, a hole or a tunnel, which stays a free face
    double outside = 0;      ///< outside the rock
    double repeated = 0;     ///< in the rock along an earlier joint, where it counts
    double p10 = 0;          ///< 1/m: joints per length of a scanline perpendicular to the mean direction
    double p20 = 0;          ///< 1/m2: traces with their midpoint in the rock, per area
    double p21 = 0;          ///< m/m2: length in the rock, retained and pruned, per area
    double p10_target = 0;   ///< 1/m; 0 without a target, here and below
    double p20_target = 0;   ///< 1/m2
    double p21_target = 0;   ///< m/m2
    double count_target = 0;
    /// Length in the rock, m, by classes of direction of 10 degrees, from -90 to 90.
    std::array<double, 18> length_by_direction = {};
    bool weighted_by_section = false;  ///< its planes were drawn as often as the section meets them
};

struct NetworkReport {
    std::vector<JointBalance> joints;  ///< in the order of the traces
};

/// Measures the joints after noding. The densities are averages over all rock, or over the rock in the set's
/// region. The targets follow from stop rule, spacing and persistence. @param rock_area m2.
/// @throws std::logic_error when the noded length of a joint exceeds its input length by more than snapping
/// allows.
NetworkReport measure_network(const CutContext& cut, double rock_area);

/// The volumetric joint count, joints per m3 [palmstrom2005]: the sum of the frequencies of all sets, each
/// across its mean direction. It is that of the rock if all joints strike across the section; other joints
/// are closer to each other than in the section.
double volumetric_joint_count(const std::vector<JointBalance>& joints);

}  // namespace rockslope::blockgen
