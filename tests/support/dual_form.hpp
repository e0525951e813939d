#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "support/recorded_step.hpp"

namespace rockslope::recorded_step {

/// The dual form of a recorded step: its unknowns are the contact forces r = (N, S, N, S, ...), as in Zheng
/// et al. (2016). The displacements K u = f + B r are eliminated with a dense factor of the base stiffness K.
/// The springs are compliances C = diag(1 / k), so that each contact obeys
///
///     (C + B^T K^-1 B) r - c + B^T K^-1 f = 0      with c = (Ne / k_n, Se / k_s) at u = 0
///
/// unless its force is at a limit: N at the least normal force, S at a bound. The matrix is symmetric
/// positive definite. With bounds that are held at given normal forces r is therefore the only minimum of a
/// convex quadratic function in a box. With Coulomb's bounds, which follow N, there may be other solutions.
class DualForm {
  public:
    explicit DualForm(const Equations& equations) : step_(equations.step()) {
        const auto size = static_cast<Eigen::Index>(6 * equations.length().size());
        const auto count = static_cast<Eigen::Index>(2 * step_.contacts.size());
        Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
        load_.resize(size);
        for (const dda::RowIndex row : equations.length().indices()) {
            stiffness.block<6, 6>(6 * row.value(), 6 * row.value()) = step_.base.stiffness[row];
            load_.segment<6>(6 * row.value()) = step_.base.load[row];
        }
        factor_.compute(stiffness);
        gradient_ = Eigen::MatrixXd::Zero(size, count);
        compliance_ = free_ = Eigen::VectorXd::Zero(count);
        for (std::size_t k = 0; k < step_.contacts.size(); ++k) add_contact(static_cast<Eigen::Index>(k));
        matrix_ = gradient_.transpose() * factor_.solve(gradient_);
        matrix_.diagonal() += compliance_;
        free_ -= gradient_.transpose() * factor_.solve(load_);
    }

    /// The bounds of shear forces under normal forces.
    struct Bounds {
        Eigen::VectorXd least, most;
    };
    /// The bounds at the normal forces of r.
    Bounds bounds_at(const Eigen::VectorXd& r) const {
        Bounds bounds{r, r};
        for (Eigen::Index k = 0; k < r.size() / 2; ++k)
            std::tie(bounds.least[2 * k + 1], bounds.most[2 * k + 1]) = bounds_of(k, r[2 * k]);
        return bounds;
    }
    /// The forces by which a projected successive over-relaxation ends.
    struct Result {
        Eigen::VectorXd forces;
        int sweeps = 0;
        bool converged = false;
    };
    /// Relaxes the forces from none, one after the other, until none changes by more than 1e-12 of the
    /// largest in a sweep. @param held bounds of the shear forces; null: they follow the normal forces.
    Result relax(const Bounds* held, int most_sweeps) const {
        constexpr double over_relaxation = 1.5;
        Result result;
        Eigen::VectorXd& r = result.forces;
        r = Eigen::VectorXd::Zero(free_.size());
        while (result.sweeps < most_sweeps && !result.converged) {
            double change = 0;
            for (Eigen::Index i = 0; i < r.size(); ++i) {
                if (compliance_[i] == 0) continue;
                const double excess = free_[i] - matrix_.col(i).dot(r);
                const double next = limited(i, r[i] + over_relaxation * excess / matrix_(i, i), r, held);
                change = std::max(change, std::abs(next - r[i]));
                r[i] = next;
            }
            ++result.sweeps;
            result.converged = change <= 1e-12 * r.cwiseAbs().maxCoeff();
        }
        return result;
    }
    /// The displacements under contact forces, per row.
    dda::PerRow<dda::Vec6> displacement(const Eigen::VectorXd& r) const {
        const Eigen::VectorXd u = factor_.solve(load_ + gradient_ * r);
        dda::PerRow<dda::Vec6> rows;
        for (Eigen::Index at = 0; at < u.size(); at += 6) rows.push_back(u.segment<6>(at));
        return rows;
    }

  private:
    const dda::LimitedContact& contact(Eigen::Index k) const {
        return step_.contacts[dda::ContactIndex(static_cast<std::size_t>(k))];
    }
    void add_contact(Eigen::Index k) {
        const dda::LimitedContact& c = contact(k);
        for (const dda::RowIndex row : {c.rows->first, c.rows->second}) {
            if (!row.exists()) continue;
            gradient_.block<6, 1>(6 * row.value(), 2 * k) = c.rows->project_on_row(row, c.opening);
            gradient_.block<6, 1>(6 * row.value(), 2 * k + 1) = -c.rows->project_on_row(row, c.shearing);
        }
        if (c.normal_stiffness > 0) compliance_[2 * k] = 1 / c.normal_stiffness;
        if (c.shear_stiffness > 0) compliance_[2 * k + 1] = 1 / c.shear_stiffness;
        free_[2 * k] = compliance_[2 * k] * c.origin.normal;
        free_[2 * k + 1] = compliance_[2 * k + 1] * c.origin.shear;
    }
    std::pair<double, double> bounds_of(Eigen::Index k, double normal) const {
        const dda::LimitedContact& c = contact(k);
        const double pressed = std::max(normal, c.floor);
        return {-c.backward.at(pressed) - c.tilt * normal, c.forward.at(pressed) - c.tilt * normal};
    }
    double limited(Eigen::Index i, double force, const Eigen::VectorXd& r, const Bounds* held) const {
        if (i % 2 == 0) return std::max(force, contact(i / 2).least_normal);
        if (held != nullptr) return std::clamp(force, held->least[i], held->most[i]);
        const auto [least, most] = bounds_of(i / 2, r[i - 1]);
        return std::clamp(force, least, most);
    }

    dda::LimitedStep step_;
    Eigen::VectorXd load_;
    Eigen::LDLT<Eigen::MatrixXd> factor_;
    Eigen::MatrixXd gradient_;    ///< B
    Eigen::VectorXd compliance_;  ///< the diagonal of C; 0 for a bolt's normal force
    Eigen::VectorXd free_;        ///< c - B^T K^-1 f
    Eigen::MatrixXd matrix_;
};

}  // namespace rockslope::recorded_step
