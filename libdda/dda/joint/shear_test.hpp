#pragma once

#include <vector>

#include "dda/joint/joint_law.hpp"

namespace rockslope::dda {

/// Normal boundary condition of a shear test.
enum class NormalBoundary { constant_stress, constant_stiffness, constant_volume, prescribed_stress };

/// A direct shear test of one joint, without blocks, as in a laboratory.
struct ShearTest {
    JointMaterial material;
    double length = 0;         ///< m, of the joint, positive
    double normal_stress = 0;  ///< Pa, at the start, compression positive
    NormalBoundary boundary = NormalBoundary::constant_stress;
    double boundary_stiffness = 0;  ///< Pa/m, for constant stiffness
    std::vector<double> path;       ///< m, displacements in the order of the test, which starts at 0
    /// Pa, for prescribed stress: the normal stress at each point of the path, not negative; 0: the joint is
    /// open. Linear between the points.
    std::vector<double> path_stress;
    double increment = 0;  ///< m, longest displacement between two rows, positive
};

struct ShearTestRow {
    double displacement = 0;   ///< m
    double shear_stress = 0;   ///< Pa, over the whole length, resists motion in the positive direction
    double normal_stress = 0;  ///< Pa, compression positive
    double dilation = 0;       ///< m
    double slip = 0;           ///< m, plastic
    bool sliding = false;
    double work = 0;  ///< J/m2, done on the joint since the start, Eq. (84)
    JointRecord record;
};

/// The largest fall of the work in a test, J/m2: below zero, or from one instant at which the joint is open
/// to a later one. It stores nothing then, so what falls is energy that the joint created. 0 for a joint that
/// creates none.
double created_energy(const std::vector<ShearTestRow>& rows);

/// Stiffness of the shear spring in the test, Pa/m: the material's, or else the law's at the initial normal
/// stress; 0 if neither has one.
double shear_stiffness(const ShearTest& test);

/// The rows of a test, from the start at zero displacement. Under constant stress they do not depend on the
/// increment, but for the work, which is that of a stress linear between the rows. Where a stress is
/// prescribed, it changes before the displacement of an increment. Otherwise the normal stress of a row is in
/// equilibrium with its dilation, Eq. (67), and acts during the increment before the row.
/// @pre shear_stiffness(test) > 0, and a compressible joint if the
/// volume is constant.
std::vector<ShearTestRow> run_shear_test(const ShearTest& test);

/// The rows at the points of the path only, one for each.
std::vector<ShearTestRow> shear_test_at_path_points(const ShearTest& test);

}  // namespace rockslope::dda
