// Steps that runs have recorded, solved by patches and exact linear solutions in turn: small ones of this
// project, in `recorded` beside this file, and larger ones that are kept outside the sources.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "support/external_data.hpp"
#include "support/packed_step.hpp"
#include "support/recorded_files.hpp"
#include "support/recorded_scenes.hpp"
#include "support/recorded_solution.hpp"
#include "support/sanitized.hpp"

namespace rockslope::recorded_steps_test {
namespace {

using namespace recorded_step;

/// Writes the least, the median and the largest of some counts as properties of the test.
void record_distribution(const std::string& name, std::vector<int> counts) {
    std::sort(counts.begin(), counts.end());
    testing::Test::RecordProperty(name + "_least", counts.front());
    testing::Test::RecordProperty(name + "_median", counts[counts.size() / 2]);
    testing::Test::RecordProperty(name + "_largest", counts.back());
}

/// What the steps of a test took.
struct Counts {
    std::vector<int> factorizations, patches, pivots, before;

    void add(const RecordedStep& recorded, int passes, const Solution& solution) {
        factorizations.push_back(passes);
        patches.push_back(solution.taken().patches);
        pivots.push_back(solution.taken().borders);
        before.push_back(recorded.factorizations);
    }
    void record() const {
        record_distribution("factorizations", factorizations);
        record_distribution("patches", patches);
        record_distribution("pivots", pivots);
        record_distribution("factorizations_of_the_run", before);
    }
};

/// Whether a contact is farther from the borders of its piece than the forces are accurate.
bool is_clear(const dda::LimitedContact& contact, dda::RowSpan<const dda::Vec6> d, double tolerance) {
    const dda::ElasticForces at = contact.elastic_at(d);
    for (const double normal : {-tolerance, tolerance})
        for (const double shear : {-tolerance, tolerance})
            if (!(contact.piece_at(at + dda::ElasticForces{normal, shear}) == contact.piece_at(at)))
                return false;
    return true;
}

// A run balances its step to the tolerance of forces T. Forces of T on all blocks change the forces of
// contacts by up to 12 T in the hardest of these steps, where half of the contacts slide. Both solutions are
// therefore taken on to T / 10000 before they are compared: that of the run from its states, and that by
// patches from the states at the start.
TEST(RecordedSteps, HaveTheStatesAndDisplacementsThatTheirRunsFound) {
    Counts counts;
    for (const auto& file : recorded_files()) {
        SCOPED_TRACE(file.filename());
        const RecordedStep recorded = read_step(file);
        const double exact = 1e-4 * recorded.tolerance;
        Solution solution(recorded);
        const int passes = solution.solve(15, [&](double) { return exact; });
        ASSERT_LE(passes, 15);
        counts.add(recorded, passes, solution);
        Solution run = Solution::from_found(recorded);
        ASSERT_LE(run.solve(3, [&](double) { return exact; }), 3);
        const Equations& equations = solution.equations();
        EXPECT_LT(largest_unbalanced(equations, equations.found()), recorded.tolerance) << "the recording";
        EXPECT_LT(largest_unbalanced(equations, solution.displacement()), exact);
        double stiffness = 0;
        for (const dda::LimitedContact& c : equations.step().contacts) {
            stiffness = std::max(stiffness, c.normal_stiffness);
            const dda::Vec2 by_run = forces_at(c, run.displacement());
            EXPECT_LT((forces_at(c, equations.found()) - by_run).cwiseAbs().maxCoeff(),
                      20 * recorded.tolerance);
            EXPECT_LT((forces_at(c, solution.displacement()) - by_run).cwiseAbs().maxCoeff(), 20 * exact);
            if (!is_clear(c, run.displacement(), 20 * exact)) continue;
            EXPECT_EQ(c.piece_at(c.elastic_at(solution.displacement())),
                      c.piece_at(c.elastic_at(run.displacement())));
        }
        // A force moves a contact by force / stiffness, and a pile of contacts by some times that.
        for (const dda::RowIndex row : equations.found().indices())
            EXPECT_LT((solution.displacement()[row] - run.displacement()[row]).cwiseAbs().maxCoeff(),
                      100 * 20 * exact / stiffness);
    }
    counts.record();
}

// A step that a run records comes back from its file with the numbers that the file has.
TEST(RecordedSteps, AreReadAsTheyAreWritten) {
    for (const auto& file : recorded_files()) {
        SCOPED_TRACE(file.filename());
        const auto copy = std::filesystem::path(testing::TempDir()) / ("copy-" + file.filename().string());
        write_step(read_step(file), copy);
        EXPECT_EQ(contents_of(copy), contents_of(file));
        std::filesystem::remove(copy);
    }
}

TEST(RecordedSteps, AreRefusedInAnotherFormat) {
    const auto file = std::filesystem::path(testing::TempDir()) / "other.step";
    for (const char* text : {"", "recorded_step 2\n", "recorded_step 1\niterations 3 factorizations"}) {
        write_text(file, text);
        EXPECT_THROW(read_step(file), std::runtime_error) << text;
    }
    std::filesystem::remove(file);
}

// Writes the files anew, after a change of their format or of the engine: unit_dda
// --gtest_filter='*AreRecordedAnew' --gtest_also_run_disabled_tests
TEST(RecordedSteps, DISABLED_AreRecordedAnew) {
    for (const RecordedScene& scene : recorded_scenes()) {
        const RecordedStep step = record(scene);
        write_step(step, recorded_folder() / (scene.name + ".step"));
        std::printf("%s: %zu blocks, %zu contacts, %d iterations\n", scene.name.c_str(), step.rows.size(),
                    step.contacts.size(), step.iterations);
    }
}

TEST(RecordedSteps, OfLargerSlopesAreSolvedByPatchesAndAFewLinearSolutions) {
    const auto folder = external_data("contact-steps");
    if (!folder) GTEST_SKIP() << external_data_missing("contact-steps");
    std::vector<std::filesystem::path> files;
    // The larger ones take a minute and a half under a sanitizer.
    const std::uintmax_t largest = libraries_are_sanitized() ? 250'000 : 10'000'000;
    for (const auto& entry : std::filesystem::directory_iterator(*folder))
        if (entry.path().extension() == ".xz" && entry.file_size() < largest) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ASSERT_FALSE(files.empty());
    constexpr int allowed = 15;
    double sum = 0, sum_before = 0;
    Counts counts;
    for (const std::filesystem::path& file : files) {
        const PackedStep packed = read_packed_step(file);
        Solution solution(packed.step);
        const int passes = solution.solve(allowed, [&](double largest_force) {
            return std::max(packed.force_tolerance * largest_force, packed.smallest_force);
        });
        EXPECT_LE(passes, allowed) << file.filename();
        std::printf(
            "%s: %d linear solutions, %d patches; the line search took %d iterations, %d factorisations\n",
            file.filename().c_str(), passes, solution.taken().patches, packed.step.iterations,
            packed.step.factorizations);
        counts.add(packed.step, passes, solution);
        sum += passes;
        sum_before += packed.step.iterations;
    }
    counts.record();
    EXPECT_LT(sum, sum_before / 4) << "linear solutions, over the iterations of the line search";
}

}  // namespace
}  // namespace rockslope::recorded_steps_test
