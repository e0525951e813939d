// The coupled linear system of the interior-point method: the shear forces follow the normal forces, which
// makes it unsymmetric. Only its symmetric part is factorised.

#include "dda/linear/minimal_residual.hpp"
#include "dda/solve/methods/interior_point.hpp"

namespace rockslope::dda {

namespace {

/// Relative residuals of the coupled system. Coarser corrections make the path fold back more often.
constexpr double predicted_residual = 0.1;
constexpr double corrected_residual = 0.03;
/// Largest number of directions, each with one substitution.
constexpr Eigen::Index direction_limit = 16;

}  // namespace

/// Finds the coupled shear forces T = E(P^-1 (b + G^T T)), with P the symmetric part and E the shear forces
/// by a displacement. The correction begins with the shear forces of the prediction.
void InteriorPoint::solve_coupled(PerRow<Vec6>& x, Change kind) {
    const bool is_correction = kind == Change::correction;
    apply_factor(x);
    const PerRow<Vec6> uncoupled = x;
    Eigen::VectorXd residual = coupled_shear(x);
    const double aim = (is_correction ? corrected_residual : predicted_residual) * residual.norm();
    if (is_correction) {
        pool_.parallel_for(x.size(), [&](std::size_t begin, std::size_t end) {
            for (const RowIndex row : indices<RowIndex>(begin, end)) x[row] += predicted_displacement_[row];
        });
        residual = coupled_shear(x) - predicted_shear_;
    }
    MinimalResidual shear(residual);
    std::vector<PerRow<Vec6>> displacements;
    while (shear.residual() > aim && shear.coefficients().size() < direction_limit) {
        displacements.push_back(displacement_by_shear(shear.direction()));
        shear.add(shear.direction() - coupled_shear(displacements.back()));
    }
    pool_.parallel_for(x.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = 0; k < displacements.size(); ++k)
            for (const RowIndex row : indices<RowIndex>(begin, end))
                x[row] += shear.coefficients()[static_cast<Eigen::Index>(k)] * displacements[k][row];
    });
    if (is_correction) return;
    predicted_shear_ = shear.solution();
    predicted_displacement_.resize(x.size());
    pool_.parallel_for(x.size(), [&](std::size_t begin, std::size_t end) {
        for (const RowIndex row : indices<RowIndex>(begin, end))
            predicted_displacement_[row] = x[row] - uncoupled[row];
    });
}

Eigen::VectorXd InteriorPoint::coupled_shear(RowSpan<const Vec6> displacement) const {
    Eigen::VectorXd shear(static_cast<Eigen::Index>(contacts_.size()));
    pool_.parallel_for(contacts_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const PathContact& c = contacts_[i];
            const double factor = c.coupling * c.normal_fraction * c.normal_stiffness;
            double& force = shear[static_cast<Eigen::Index>(i)];
            force = 0;
            if (factor == 0) continue;
            const Vec2 relative = p_.springs[c.contact].rows.relative_displacement(displacement);
            force = factor * c.opening.direction.dot(relative);
        }
    });
    return shear;
}

PerRow<Vec6> InteriorPoint::displacement_by_shear(const Eigen::VectorXd& shear) {
    PerRow<Vec6> displacement;
    displacement.assign(displacement_.size(), Vec6::Zero());
    const auto force_of = [&](std::size_t i) {
        return shear[static_cast<Eigen::Index>(i)] * p_.springs[contacts_[i].contact].shear.direction;
    };
    add_forces(force_of, displacement);
    apply_factor(displacement);
    return displacement;
}

void InteriorPoint::apply_factor(PerRow<Vec6>& load) {
    solver_.apply_factor(load);
    ++substitutions_;
}

}  // namespace rockslope::dda
