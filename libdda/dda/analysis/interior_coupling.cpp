// The coupled linear system of the interior-point method: the shear forces follow the normal forces, which
// makes it unsymmetric. Only its symmetric part is factorised.

#include <Eigen/QR>
#include <cmath>
#include <functional>

#include "dda/analysis/interior_point.hpp"

namespace rockslope::dda {

namespace {

/// Relative residuals of the coupled system. Coarser corrections make the path fold back more often.
constexpr double predicted_residual = 0.1;
constexpr double corrected_residual = 0.03;
/// Largest number of directions, each with one substitution.
constexpr int max_directions = 16;

}  // namespace

/// GMRES [saadschultz1986] for the coupled shear forces T = E(P^-1 (b + G^T T)), with P the symmetric part
/// and E the shear forces by a displacement. The correction begins with the shear forces of the prediction.
void InteriorPoint::solve_coupled(PerRow<Vec6>& x, Change kind) {
    const bool is_correction = kind == Change::correction;
    apply_factor(x);
    const PerRow<Vec6> uncoupled = x;
    directions_.resize(max_directions + 1);
    displacements_.resize(max_directions);
    std::vector<double>& residual = directions_[0];
    coupled_shear(x, residual);
    const double aim =
        (is_correction ? corrected_residual : predicted_residual) * std::sqrt(product(residual, residual));
    if (is_correction) {
        for (const RowIndex row : x.indices()) x[row] += predicted_displacement_[row];
        coupled_shear(x, residual);
        for (std::size_t i = 0; i < residual.size(); ++i) residual[i] -= predicted_shear_[i];
    } else {
        predicted_shear_.assign(contacts_.size(), 0);
    }
    const double norm = std::sqrt(product(residual, residual));
    int count = 0;
    Eigen::VectorXd coefficients;
    if (norm > aim) {
        for (double& value : residual) value /= norm;
        Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(max_directions + 1, max_directions);
        Eigen::VectorXd first = Eigen::VectorXd::Zero(max_directions + 1);
        first[0] = norm;
        for (double remaining = norm; remaining > aim && count < max_directions;) {
            const std::vector<double>& direction = directions_[count];
            PerRow<Vec6>& displacement = displacements_[count];
            displacement.assign(x.size(), Vec6::Zero());
            const auto force_of = [&](std::size_t i) {
                return direction[i] * p_.springs[contacts_[i].contact].shear.direction;
            };
            add_forces(force_of, displacement);
            apply_factor(displacement);
            std::vector<double>& next = directions_[count + 1];
            coupled_shear(displacement, next);
            for (std::size_t i = 0; i < next.size(); ++i) next[i] = direction[i] - next[i];
            for (int j = 0; j <= count; ++j) {
                hessenberg(j, count) = product(next, directions_[j]);
                for (std::size_t i = 0; i < next.size(); ++i)
                    next[i] -= hessenberg(j, count) * directions_[j][i];
            }
            const double length = std::sqrt(product(next, next));
            hessenberg(count + 1, count) = length;
            ++count;
            const Eigen::MatrixXd h = hessenberg.topLeftCorner(count + 1, count);
            coefficients = h.householderQr().solve(first.head(count + 1));
            remaining = length > 0 ? (h * coefficients - first.head(count + 1)).norm() : 0;
            if (length > 0)
                for (double& value : next) value /= length;
        }
    }
    pool_.parallel_for(count == 0 ? 0 : x.size(), [&](std::size_t begin, std::size_t end) {
        for (int j = 0; j < count; ++j)
            for (const RowIndex row : indices<RowIndex>(begin, end))
                x[row] += coefficients[j] * displacements_[j][row];
    });
    if (is_correction) return;
    for (int j = 0; j < count; ++j)
        for (std::size_t i = 0; i < predicted_shear_.size(); ++i)
            predicted_shear_[i] += coefficients[j] * directions_[j][i];
    predicted_displacement_ = x;
    for (const RowIndex row : x.indices()) predicted_displacement_[row] -= uncoupled[row];
}

void InteriorPoint::coupled_shear(RowSpan<const Vec6> displacement, std::vector<double>& shear) const {
    shear.resize(contacts_.size());
    pool_.parallel_for(contacts_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const PathContact& c = contacts_[i];
            const double factor = c.coupling * c.normal_fraction * c.normal_stiffness;
            shear[i] = 0;
            if (factor == 0) continue;
            const Vec2 relative = p_.springs[c.contact].rows.relative_displacement(displacement);
            shear[i] = factor * c.opening.direction.dot(relative);
        }
    });
}

double InteriorPoint::product(const std::vector<double>& a, const std::vector<double>& b) const {
    const auto product_of_chunk = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += a[i] * b[i];
        return sum;
    };
    return pool_.parallel_reduce(a.size(), 0.0, product_of_chunk, std::plus<>());
}

void InteriorPoint::apply_factor(PerRow<Vec6>& load) {
    solver_.apply_factor(load);
    ++substitutions_;
}

}  // namespace rockslope::dda
