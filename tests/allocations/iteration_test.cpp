// What a step asks operator new for: as many allocations of memory however many blocks there are, and what is
// worked on is kept from one open-close iteration to the next.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "dda/analysis/step.hpp"
#include "support/walls.hpp"

using namespace rockslope;

namespace {

/// Bytes from which a piece of memory is work space, and not bookkeeping that is as long in a small model.
constexpr std::size_t large = 2048;
std::atomic<long> large_allocations{0};
std::atomic<long> all_allocations{0};

void* take(std::size_t size) {
    ++all_allocations;
    if (size >= large) ++large_allocations;
    if (void* piece = std::malloc(size > 0 ? size : 1)) return piece;
    throw std::bad_alloc();
}

}  // namespace

// All that the library's own forms do not come back to, and with them what they are freed by: a sanitizer
// holds each new to the delete of its family.
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
void operator delete(void* piece) noexcept {
    std::free(piece);
}
void operator delete(void* piece, std::size_t /*unused*/) noexcept {
    std::free(piece);
}
void operator delete(void* piece, const std::nothrow_t& /*unused*/) noexcept {
    std::free(piece);
}

namespace {

/// Large allocations that a step asks for which is given up after so many iterations.
long large_allocations_in(dda::TimeStepper& stepper, dda::Stage stage, const dda::State& state,
                          int iterations) {
    stage.control.iteration_limit = iterations;
    const long before = large_allocations;
    const dda::StepAttempt attempt = stepper.advance(stage, state, 0.005);
    EXPECT_EQ(attempt.report.iterations, iterations) << "the step is to be a hard one";
    return large_allocations - before;
}

/// Changes of the held forces that an iteration may tell, each in memory of its own for the step, and how
/// many allocations that is.
constexpr int max_directions = 12;
constexpr int allocations_per_direction = 4;

// A wall let go: everything slides. What is worked on is made in the first iterations.
TEST(Allocations, LaterIterationsAllocateOnlyNewDirections) {
    const dda::Model model = scene::running_bond_wall(12, 12, 100).model;
    for (const int threads : {1, 2}) {
        dda::TimeStepper stepper(model, threads);
        const dda::State state = dda::initial_state(model);
        large_allocations_in(stepper, {}, state, 2);
        const long few = large_allocations_in(stepper, {}, state, 4);
        for (const int iterations : {8, 12, 16}) {
            EXPECT_LE(large_allocations_in(stepper, {}, state, iterations) - few,
                      max_directions * allocations_per_direction)
                << iterations << " iterations, " << threads << " threads";
        }
    }
}

/// Pieces of any size that a warm step of a wall asks for.
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

// The walls are as wide as each other, for the list of the contacts of the block below grows as they come.
TEST(Allocations, AllocationsPerStepDoNotDependOnTheNumberOfBlocks) {
    const long few = allocations_of_step(12, 3);
    EXPECT_GT(few, 0);
    EXPECT_EQ(allocations_of_step(12, 12), few);
    EXPECT_EQ(allocations_of_step(12, 40), few);
}

}  // namespace
