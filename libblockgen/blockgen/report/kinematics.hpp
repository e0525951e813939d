#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/mesh/block_mesh.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

/// How a block would begin to move under its weight, if its neighbours stand still.
enum class BlockMode : std::uint8_t {
    enclosed,          ///< has no free face
    tapered,           ///< has one, but its joints hold it: it cannot move away in any direction
    stable,            ///< could be taken out, but no way leads down
    falling,           ///< away from all its joints
    sliding,           ///< along one of its joints
    sliding_two_faces  ///< along two lines of joints that are parallel
};

/// A removable block that its weight would move.
struct KeyBlock {
    std::int32_t block = 0;
    BlockMode mode = BlockMode::falling;
    Point direction;              ///< of the first movement, a unit vector
    double factor_of_safety = 0;  ///< friction over driving force; 0 for a falling block
    std::int32_t joint = -1;      ///< along which it slides, index into BlockMesh::joints; -1 when it falls
    double area = 0;              ///< m2
};

struct KinematicReport {
    std::vector<BlockMode> mode;   ///< per block
    std::vector<KeyBlock> blocks;  ///< ascending factor of safety, then by number
};

/// Screens blocks for removability by the theory of Goodman and Shi (1985, Block Theory) in two dimensions. A
/// block may move in the direction d when d.n >= 0 for the inward normal n of each of its joints: their joint
/// pyramid. It is removable when such a direction exists; being finite it then has a free face. Weight moves
/// it in the direction of the pyramid nearest to the vertical: down when the pyramid holds it, otherwise
/// along a joint, with the factor of safety tan(friction of its material) / tan(dip). One block at a time,
/// translation only, without cohesion or water: neither toppling nor a row of blocks that push each other is
/// seen. The sides of the domain's bounding box named in `fixed_sides` are no free faces; fixed and
/// prescribed blocks count as enclosed.
KinematicReport screen_blocks(const BlockMesh& mesh, const KinematicScreen& screen, const Bounds& bounds,
                              double grid);

}  // namespace rockslope::blockgen
