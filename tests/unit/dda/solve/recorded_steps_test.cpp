// Steps that runs have recorded: slopes of 381 and 993 blocks that settle, are shaken and cohere, hard steps
// among them, and such as the line search gave up after a hundred iterations. They are solved by patches and
// exact linear solutions in turn.

#include <gtest/gtest.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dda/solve/patches.hpp"
#include "support/external_data.hpp"
#include "support/recorded_step.hpp"

namespace rockslope::recorded_steps_test {
namespace {

using namespace rockslope::dda;
using recorded_step::RecordedStep;
using Sparse = Eigen::SparseMatrix<double>;

/// The displacements of a recorded step, solved for anew.
class Solution {
  public:
    explicit Solution(const RecordedStep& recorded) : recorded_(recorded), step_(recorded.step()) {
        displacement_.assign(recorded.rows(), Vec6::Zero());
    }
    /// @return the number of linear solutions; one more than allowed if that does not suffice.
    int passes(int allowed) {
        std::vector<Piece> pieces = recorded_.start();
        const std::vector<double> length(displacement_.size(), 1.0);
        for (int pass = 1; pass <= allowed; ++pass) {
            solve(pieces);
            const double tolerance = recorded_.tolerance(largest_force());
            if (unbalanced() < tolerance) return pass;
            const PatchAims aims{tolerance / 2, pass == 1 ? 0 : 0.02, length, false, {}};
            patch_count_ += patches_.relax(step_, aims, displacement_, ThreadPool(1)).patches;
            for (std::size_t k = 0; k < pieces.size(); ++k) {
                const LimitedContact& c = step_.contacts[k];
                if (c.may_close) pieces[k] = c.piece_at(c.elastic_at(displacement_));
            }
        }
        return allowed + 1;
    }
    int patches() const { return patch_count_; }

  private:
    /// Sets the displacement to the solution of the coupled linear system of given pieces.
    void solve(const std::vector<Piece>& pieces) {
        std::vector<Eigen::Triplet<double>> entries;
        const auto size = static_cast<Eigen::Index>(6 * displacement_.size());
        Eigen::VectorXd load(size);
        for (std::size_t k = 0; k < displacement_.size(); ++k) {
            load.segment<6>(6 * static_cast<Eigen::Index>(k)) = step_.base.load[k];
            add(entries, RowIndex(k), RowIndex(k), step_.base.stiffness[k]);
        }
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            const LimitedContact& c = step_.contacts[k];
            if (!c.may_close) continue;
            const PieceForces forces = c.on(pieces[k]);
            const Vec2 at_zero = forces.at(c.origin);
            for (const RowIndex row : {c.rows->first, c.rows->second}) {
                if (!row.exists()) continue;
                const Vec6 opening = c.rows->project_on_row(row, c.opening);
                const Vec6 shearing = c.rows->project_on_row(row, c.shearing);
                load.segment<6>(6 * row.value()) -= at_zero.y() * shearing - at_zero.x() * opening;
                const Vec6 by_normal = forces.slope(1, 0) * shearing - forces.slope(0, 0) * opening;
                const Vec6 by_shear = forces.slope(1, 1) * shearing;
                for (const RowIndex other : {c.rows->first, c.rows->second}) {
                    if (!other.exists()) continue;
                    const Vec6 normal = -c.normal_stiffness * c.rows->project_on_row(other, c.opening);
                    const Vec6 shear = c.shear_stiffness * c.rows->project_on_row(other, c.shearing);
                    add(entries, row, other, by_normal * normal.transpose() + by_shear * shear.transpose());
                }
            }
        }
        Sparse matrix(size, size);
        matrix.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SparseLU<Sparse> factors(matrix);
        const Eigen::VectorXd found = factors.solve(load);
        for (std::size_t k = 0; k < displacement_.size(); ++k)
            displacement_[k] = found.segment<6>(6 * static_cast<Eigen::Index>(k));
    }
    static void add(std::vector<Eigen::Triplet<double>>& entries, RowIndex row, RowIndex column,
                    const Mat6& part) {
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                entries.emplace_back(6 * row.value() + i, 6 * column.value() + j, part(i, j));
    }
    Vec2 forces_of(const LimitedContact& c) const {
        if (!c.may_close) return Vec2::Zero();
        const ElasticForces elastic = c.elastic_at(displacement_);
        return c.on(c.piece_at(elastic)).at(elastic);
    }
    double largest_force() const {
        double largest = 0;
        for (const LimitedContact& c : step_.contacts)
            largest = std::max(largest, forces_of(c).cwiseAbs().maxCoeff());
        return largest;
    }
    double unbalanced() const {
        std::vector<Vec6> force(displacement_.size());
        for (std::size_t k = 0; k < force.size(); ++k)
            force[k] = step_.base.stiffness[k] * displacement_[k] - step_.base.load[k];
        for (const LimitedContact& c : step_.contacts) {
            const Vec2 forces = forces_of(c);
            for (const RowIndex row : {c.rows->first, c.rows->second})
                if (row.exists())
                    force[row.value()] +=
                        c.rows->project_on_row(row, Vec2(forces.y() * c.shearing - forces.x() * c.opening));
        }
        double largest = 0;
        for (const Vec6& each : force) largest = std::max(largest, each.cwiseAbs().maxCoeff());
        return largest;
    }

    const RecordedStep& recorded_;
    LimitedStep step_;
    Patches patches_;
    std::vector<Vec6> displacement_;
    int patch_count_ = 0;
};

TEST(RecordedSteps, AreSolvedByPatchesAndAFewLinearSolutions) {
    const auto folder = external_data("contact-steps");
    if (!folder) GTEST_SKIP() << external_data_missing("contact-steps");
    std::vector<std::filesystem::path> files;
#if defined(__SANITIZE_ADDRESS__)
    constexpr std::uintmax_t largest = 250'000;  // the larger ones take a minute and a half
#else
    constexpr std::uintmax_t largest = 10'000'000;
#endif
    for (const auto& entry : std::filesystem::directory_iterator(*folder))
        if (entry.path().extension() == ".xz" && entry.file_size() < largest) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ASSERT_FALSE(files.empty());
    constexpr int allowed = 15;
    double sum = 0, sum_before = 0;
    for (const std::filesystem::path& file : files) {
        const RecordedStep recorded(file);
        Solution solution(recorded);
        const int passes = solution.passes(allowed);
        EXPECT_LE(passes, allowed) << file.filename();
        std::printf(
            "%s: %d linear solutions, %d patches; the line search took %d iterations, %d factorisations\n",
            file.filename().c_str(), passes, solution.patches(), recorded.iterations(),
            recorded.factorizations());
        sum += passes;
        sum_before += recorded.iterations();
    }
    EXPECT_LT(sum, sum_before / 4) << "linear solutions, over the iterations of the line search";
}

}  // namespace
}  // namespace rockslope::recorded_steps_test
