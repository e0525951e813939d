// Memory allocations of a step: their number does not depend on the number of blocks, and the open-close
// iteration keeps its work space from one iteration to the next.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

#include "dda/analysis/step.hpp"
#include "support/walls.hpp"

using namespace rockslope;

namespace {

/// Smallest size of a large allocation, bytes. Smaller ones do not grow with the model.
constexpr std::size_t large = 2048;
std::atomic<long> large_allocations{0};
std::atomic<long> all_allocations{0};

void* take(std::size_t size) {
    ++all_allocations;
    if (size >= large) ++large_allocations;
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}

}  // namespace

// Replaces the basic forms of operator new, to which the other forms of the library forward, and the matching
// forms of delete: a sanitizer reports a mismatch of the two.
void* operator new(std::size_t size) {
    return take(size);
}
void* operator new(std::size_t size, const std::nothrow_t& /*unused*/) noexcept {
    try {
        return take(size);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*unused*/) noexcept {
    std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t& /*unused*/) noexcept {
    std::free(memory);
}

namespace {

/// The number of large allocations in a step that is limited to `iterations` iterations.
long large_allocations_in(dda::TimeStepper& stepper, dda::Stage stage, const dda::State& state,
                          int iterations) {
    stage.control.iteration_limit = iterations;
    const long before = large_allocations;
    const dda::StepAttempt attempt = stepper.advance(stage, state, 0.005);
    EXPECT_EQ(attempt.report.iterations, iterations) << "the step must need more iterations";
    return large_allocations - before;
}

/// The fewest large allocations in some runs of that step. With several threads the patches that a thread
/// gets are a matter of chance, and its work space grows with the largest one that it has had.
long fewest_large_allocations_in(dda::TimeStepper& stepper, const dda::Stage& stage, const dda::State& state,
                                 int iterations, int threads) {
    const int runs = threads == 1 ? 1 : 4;
    long fewest = std::numeric_limits<long>::max();
    for (int run = 0; run < runs; ++run)
        fewest = std::min(fewest, large_allocations_in(stepper, stage, state, iterations));
    return fewest;
}

/// Largest number of search directions of the friction coupling, and the allocations for each. Their memory
/// is kept for the step.
constexpr int max_directions = 12;
constexpr int allocations_per_direction = 4;

// A wall released from rest, in which all contacts slide. The work space is allocated in the first
// iterations.
TEST(Allocations, LaterIterationsAllocateOnlyNewDirections) {
    const dda::Model model = scene::running_bond_wall(12, 24, 100).model;
    for (const int threads : {1, 2}) {
        dda::TimeStepper stepper(model, threads);
        const dda::State state = dda::initial_state(model);
        large_allocations_in(stepper, {}, state, 2);
        const long few = fewest_large_allocations_in(stepper, {}, state, 3, threads);
        for (const int iterations : {4, 5, 6}) {
            EXPECT_LE(fewest_large_allocations_in(stepper, {}, state, iterations, threads) - few,
                      max_directions * allocations_per_direction)
                << iterations << " iterations, " << threads << " threads";
        }
    }
}

/// The number of allocations of any size in the third step of a wall.
long allocations_of_step(int columns, int rows) {
    const dda::Model model = scene::running_bond_wall(columns, rows, 100).model;
    dda::TimeStepper stepper(model, 1);
    dda::State state = dda::initial_state(model);
    long allocations = 0;
    for (int k = 0; k < 3; ++k) {
        const long before = all_allocations;
        dda::StepAttempt attempt = stepper.advance({}, state, 1e-5);
        allocations = all_allocations - before;
        EXPECT_EQ(attempt.rejection, dda::Rejection::none);
        state = std::move(attempt.state);
    }
    return allocations;
}

// All walls have the same width, because the contact list of the base block grows with it.
TEST(Allocations, AllocationsPerStepDoNotDependOnTheNumberOfBlocks) {
    const long few = allocations_of_step(12, 3);
    EXPECT_GT(few, 0);
    EXPECT_EQ(allocations_of_step(12, 12), few);
    EXPECT_EQ(allocations_of_step(12, 40), few);
}

}  // namespace
