#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <vector>

#include "dda/path/limited_forces.hpp"
#include "support/random_shapes.hpp"

namespace rockslope::random_patch {

/// Random blocks side by side in a row, each in contact with the next one and some with a rigid ground,
/// pressed and pushed by random loads.
class RandomPatch {
  public:
    explicit RandomPatch(unsigned seed, std::size_t blocks = 8) : random_(seed) {
        using dda::Mat6;
        for (std::size_t k = 0; k < blocks; ++k) {
            base_.stiffness.push_back(random_.magnitude(1, 1e3) * Mat6::Identity());
            base_.load.push_back(
                dda::Vec6::NullaryExpr([&](Eigen::Index) { return random_.between(-1, 1); }));
            load_ = std::max(load_, base_.load[k].cwiseAbs().maxCoeff());
        }
        for (std::size_t k = 0; k < blocks; ++k) {
            for (int repetition = 0; repetition < 2; ++repetition) {
                add_contact(k, k + 1 < blocks ? dda::RowIndex(k + 1) : dda::RowIndex::none());
                if (random_.index_below(2) == 0) add_contact(k, dda::RowIndex::none());
            }
        }
        for (std::size_t k = 0; k < contacts_.size(); ++k) contacts_[k].rows = &springs_[k].rows;
        row_contacts_.find(blocks, springs_);
    }

    std::size_t blocks() const { return base_.load.size(); }
    /// The largest load on an unknown, N per metre.
    double load() const { return load_; }
    dda::LimitedStep step() const { return {base_, row_contacts_, contacts_}; }
    std::vector<dda::RowIndex> rows() const {
        std::vector<dda::RowIndex> rows;
        for (std::size_t k = 0; k < blocks(); ++k) rows.emplace_back(k);
        return rows;
    }
    /// Displacements that change the elastic forces by several times the loads.
    std::vector<dda::Vec6> random_displacement() {
        std::vector<dda::Vec6> d(blocks());
        for (dda::Vec6& each : d)
            each = dda::Vec6::NullaryExpr([&](Eigen::Index) { return random_.between(-0.01, 0.01); });
        return d;
    }
    std::vector<dda::ElasticForces> elastic(std::span<const dda::Vec6> displacement) const {
        std::vector<dda::ElasticForces> elastic;
        for (const dda::LimitedContact& c : contacts_) elastic.push_back(c.elastic_at(displacement));
        return elastic;
    }
    /// The largest unbalanced force, N per metre.
    double unbalanced(std::span<const dda::Vec6> displacement) const {
        std::vector<dda::Vec6> force(blocks());
        for (std::size_t k = 0; k < blocks(); ++k)
            force[k] = base_.stiffness[k] * displacement[k] - base_.load[k];
        for (const dda::LimitedContact& c : contacts_) {
            const dda::ElasticForces elastic = c.elastic_at(displacement);
            const dda::Vec2 forces = c.on(c.piece_at(elastic)).at(elastic);
            const dda::Vec2 on_first = forces.y() * c.shearing - forces.x() * c.opening;
            for (const dda::RowIndex row : {c.rows->first, c.rows->second})
                if (row.exists()) force[row.value()] += c.rows->project_on_row(row, on_first);
        }
        double largest = 0;
        for (const dda::Vec6& f : force) largest = std::max(largest, f.cwiseAbs().maxCoeff());
        return largest;
    }
    /// The sign of the determinant of the matrix there.
    int determinant_sign(std::span<const dda::Vec6> displacement) const {
        const auto size = static_cast<Eigen::Index>(6 * blocks());
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
        for (std::size_t k = 0; k < blocks(); ++k)
            matrix.block<6, 6>(6 * static_cast<Eigen::Index>(k), 6 * static_cast<Eigen::Index>(k)) =
                base_.stiffness[k];
        for (const dda::LimitedContact& c : contacts_) {
            Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(2, size);
            for (const dda::RowIndex row : {c.rows->first, c.rows->second}) {
                if (!row.exists()) continue;
                gradient.block<1, 6>(0, 6 * row.value()) = c.rows->project_on_row(row, c.opening).transpose();
                gradient.block<1, 6>(1, 6 * row.value()) =
                    c.rows->project_on_row(row, c.shearing).transpose();
            }
            Eigen::MatrixXd change = gradient, force = gradient;
            change.row(0) *= -c.normal_stiffness;
            change.row(1) *= c.shear_stiffness;
            force.row(0) *= -1;
            matrix += force.transpose() * c.on(c.piece_at(c.elastic_at(displacement))).slope * change;
        }
        return matrix.partialPivLu().determinant() < 0 ? -1 : 1;
    }

  private:
    void add_contact(std::size_t first, dda::RowIndex second) {
        dda::ContactSprings springs;
        springs.rows.first = dda::RowIndex(first);
        springs.rows.second = second;
        springs.rows.first_arm = random_.between(0.2, 1) * random_.direction();
        springs.rows.second_arm = random_.between(0.2, 1) * random_.direction();
        springs_.push_back(springs);
        dda::LimitedContact c;
        c.opening = random_.direction();
        c.shearing = {c.opening.y(), -c.opening.x()};
        c.normal_stiffness = random_.magnitude(1e2, 1e4);
        c.shear_stiffness = 0.4 * c.normal_stiffness;
        c.origin = {random_.between(-0.5, 0.5), random_.between(-0.5, 0.5)};
        c.forward = c.backward = {random_.index_below(4) == 0 ? 0.2 : 0, random_.between(0.2, 1.2)};
        if (random_.index_below(4) == 0) c.tilt = random_.between(-0.3, 0.3);
        if (random_.index_below(4) == 0) c.least_normal = -random_.between(0.1, 0.5);
        // A bond that bears any tension, and a bolt that yields.
        const auto special = random_.index_below(16);
        if (special == 0) c.least_normal = -std::numeric_limits<double>::infinity();
        if (special == 1) {
            c.opening = dda::Vec2::Zero();
            c.normal_stiffness = c.origin.normal = c.least_normal = c.tilt = 0;
            c.forward = c.backward = {random_.between(0.1, 0.5), 0};
        }
        contacts_.push_back(c);
    }

    scene::RandomSource random_;
    double load_ = 0;
    dda::BaseSystem base_;
    std::vector<dda::ContactSprings> springs_;
    std::vector<dda::LimitedContact> contacts_;
    dda::RowContacts row_contacts_;
};

}  // namespace rockslope::random_patch
