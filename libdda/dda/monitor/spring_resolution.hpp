#pragma once

#include <span>
#include <vector>

#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// How the steps of a dynamic stage resolve the springs of a joint material, for a block of median mass that
/// rests on one face of the median length.
struct SpringResolution {
    std::size_t stage = 0;  ///< index
    JointMaterialIndex joint_material;
    double shear_period_steps = 0;   ///< steps in a period of the block on the shear spring
    double normal_period_steps = 0;  ///< steps in a period of the block on the normal spring
    double swing = 0;                ///< m, displacement of the shear spring under the block's weight
    double lost_per_period = 0;      ///< fraction of a swing's amplitude, by the time integration
};

/// A spring that loses more of its swing in a period, and swings farther than `least_swing`, is told of.
inline constexpr double largest_lost_per_period = 0.05;
inline constexpr double least_swing = 1e-4;  ///< m

/// The resolution of all joint materials in all dynamic stages. Newmark's integration damps a swing of
/// frequency omega with the ratio (gamma - 1/2) omega dt / 2, Eq. (17). None without free blocks.
std::vector<SpringResolution> spring_resolutions(const Model& model, std::span<const Stage> stages);

/// Whether the steps lose a swing that matters: a slip that follows it is too small by some of the swing.
bool loses_swing(const SpringResolution& resolution);

/// The step, s, at which a swing loses `largest_lost_per_period`. @pre loses_swing(resolution)
double step_that_keeps_swing(const SpringResolution& resolution, const Stage& stage);

}  // namespace rockslope::dda
