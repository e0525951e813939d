#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/mesh/block_mesh.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

/// Mode of the first movement of a block under its weight while its neighbours are fixed.
enum class BlockMode : std::uint8_t {
    enclosed,          ///< has no free face
    tapered,           ///< has a free face but is not removable: no direction of movement is admissible
    stable,            ///< removable, but no admissible direction leads down
    falling,           ///< moves vertically down, away from all its joints
    sliding,           ///< slides along one of its joints
    sliding_two_faces  ///< slides between two parallel joints
};

/// A removable block that moves under its weight.
struct KeyBlock {
    BlockIndex block = 0;
    BlockMode mode = BlockMode::falling;
    Point direction;              ///< of the first movement, a unit vector
    double factor_of_safety = 0;  ///< frictional resistance over driving force; 0 for a falling block
    JointIndex joint = JointIndex::none();  ///< the joint of sliding; none when it falls
    double area = 0;                        ///< m2
};

struct KinematicReport {
    PerBlock<BlockMode> mode;
    std::vector<KeyBlock> blocks;  ///< sorted by factor of safety, then by number
};

/// Screens blocks for removability by block theory (Goodman and Shi 1985) in two dimensions. A direction d is
/// admissible when d.n >= 0 for the inward normal n of each joint of the block; these directions form its
/// joint pyramid. A block with a free face is removable when its joint pyramid is not empty. Its weight moves
/// it in the admissible direction nearest to the vertical: straight down if that is admissible, otherwise
/// along a joint, with the factor of safety tan(friction angle) / tan(dip).
/// Limitations: one block at a time, translation only, no cohesion, no water; toppling, and rows of blocks
/// that push each other, are not detected. The sides of the domain's bounding box in `fixed_sides` are not
/// free faces. Fixed and prescribed blocks count as enclosed.
KinematicReport screen_blocks(const BlockMesh& mesh, const KinematicScreen& screen, const Bounds& bounds,
                              double grid);

}  // namespace rockslope::blockgen
