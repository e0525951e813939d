#pragma once

#include <Eigen/SparseLU>
#include <algorithm>
#include <vector>

#include "dda/path/patches.hpp"
#include "support/recorded_step.hpp"

namespace rockslope::recorded_step {

/// Normal and shear force of a contact by its law, N per metre; shear less tilt times normal.
inline dda::Vec2 forces_at(const dda::LimitedContact& contact, dda::RowSpan<const dda::Vec6> d) {
    if (!contact.may_close) return dda::Vec2::Zero();
    const dda::ElasticForces elastic = contact.elastic_at(d);
    return contact.on(contact.piece_at(elastic)).at(elastic);
}

/// The largest unbalanced force of a block, N per metre; moments over its length.
inline double largest_unbalanced(const Equations& equations, dda::RowSpan<const dda::Vec6> d) {
    dda::LimitedForces forces;
    forces.evaluate(equations.step(), d, equations.length(), ThreadPool(1));
    double largest = 0;
    for (const dda::RowIndex row : equations.length().indices())
        largest = std::max(largest, forces.unbalanced(row).cwiseAbs().maxCoeff());
    return largest;
}

/// A recorded step solved anew by the engine's patches, and exact linear solutions of all blocks in turn.
class Solution {
  public:
    /// From the states at the step's start.
    explicit Solution(const RecordedStep& recorded) : Solution(recorded, From::start) {}
    /// From the states that the run found: takes its solution on to another tolerance.
    static Solution from_found(const RecordedStep& recorded) { return Solution(recorded, From::found); }

    /// @param tolerance_of the tolerance, N per metre, at the largest force of a contact.
    /// @return the number of linear solutions; one more than allowed if that does not suffice.
    template <class ToleranceOf>
    int solve(int allowed, const ToleranceOf& tolerance_of) {
        const ThreadPool pool(1);
        for (int pass = 1; pass <= allowed; ++pass) {
            solve_on_pieces();
            const double tolerance = tolerance_of(largest_force());
            if (largest_unbalanced(equations_, displacement_) < tolerance) return pass;
            const dda::PatchAims aims{
                tolerance / 2, pass == 1 ? 0 : 0.02, equations_.length(), dda::PatchExtent::two_rings, {}};
            const dda::Relaxation taken = patches_.relax(step_, aims, displacement_, pool);
            taken_.patches += taken.patches;
            taken_.borders += taken.borders;
            update_pieces();
        }
        return allowed + 1;
    }
    /// The patches so far, and the borders crossed on their paths.
    const dda::Relaxation& taken() const { return taken_; }
    const dda::PerRow<dda::Vec6>& displacement() const { return displacement_; }
    const Equations& equations() const { return equations_; }

  private:
    enum class From { start, found };
    Solution(const RecordedStep& recorded, From from)
        : equations_(recorded), step_(equations_.step()), displacement_(equations_.found()) {
        for (const RecordedStep::Contact& contact : recorded.contacts) pieces_.push_back(contact.start);
        if (from == From::found) update_pieces();
    }
    void update_pieces() {
        for (const dda::ContactIndex k : pieces_.indices()) {
            const dda::LimitedContact& c = step_.contacts[k];
            if (c.may_close) pieces_[k] = c.piece_at(c.elastic_at(displacement_));
        }
    }
    /// Sets the displacement to the solution of the coupled linear system of the pieces.
    void solve_on_pieces() {
        std::vector<Eigen::Triplet<double>> entries;
        const auto size = static_cast<Eigen::Index>(6 * displacement_.size());
        Eigen::VectorXd load(size);
        for (const dda::RowIndex row : displacement_.indices()) {
            load.segment<6>(6 * row.value()) = step_.base.load[row];
            add(entries, row, row, step_.base.stiffness[row]);
        }
        for (const dda::ContactIndex k : pieces_.indices())
            if (step_.contacts[k].may_close) add_contact(step_.contacts[k], pieces_[k], entries, load);
        Eigen::SparseMatrix<double> matrix(size, size);
        matrix.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
        const Eigen::VectorXd found = factors.solve(load);
        for (const dda::RowIndex row : displacement_.indices())
            displacement_[row] = found.segment<6>(6 * row.value());
    }
    static void add_contact(const dda::LimitedContact& c, const dda::Piece& piece,
                            std::vector<Eigen::Triplet<double>>& entries, Eigen::VectorXd& load) {
        const dda::PieceForces forces = c.on(piece);
        const dda::Vec2 at_zero = forces.at(c.origin);
        for (const dda::RowIndex row : {c.rows->first, c.rows->second}) {
            if (!row.exists()) continue;
            const dda::Vec6 opening = c.rows->project_on_row(row, c.opening);
            const dda::Vec6 shearing = c.rows->project_on_row(row, c.shearing);
            load.segment<6>(6 * row.value()) -= at_zero.y() * shearing - at_zero.x() * opening;
            const dda::Vec6 by_normal = forces.slope(1, 0) * shearing - forces.slope(0, 0) * opening;
            const dda::Vec6 by_shear = forces.slope(1, 1) * shearing;
            for (const dda::RowIndex other : {c.rows->first, c.rows->second}) {
                if (!other.exists()) continue;
                const dda::Vec6 normal = -c.normal_stiffness * c.rows->project_on_row(other, c.opening);
                const dda::Vec6 shear = c.shear_stiffness * c.rows->project_on_row(other, c.shearing);
                add(entries, row, other, by_normal * normal.transpose() + by_shear * shear.transpose());
            }
        }
    }
    static void add(std::vector<Eigen::Triplet<double>>& entries, dda::RowIndex row, dda::RowIndex column,
                    const dda::Mat6& part) {
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                entries.emplace_back(6 * row.value() + i, 6 * column.value() + j, part(i, j));
    }
    double largest_force() const {
        double largest = 0;
        for (const dda::LimitedContact& c : step_.contacts)
            largest = std::max(largest, forces_at(c, displacement_).cwiseAbs().maxCoeff());
        return largest;
    }

    Equations equations_;
    dda::LimitedStep step_;
    dda::Patches patches_;
    dda::PerContact<dda::Piece> pieces_;
    dda::PerRow<dda::Vec6> displacement_;
    dda::Relaxation taken_;
};

}  // namespace rockslope::recorded_step
