#include "dda/contact/candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/random_shapes.hpp"
#include "support/scene.hpp"

namespace rockslope::candidates_test {
namespace {

using namespace scene;
using dda::CornerEdge;
using dda::Motion;

/// The candidates by a test of every pair.
std::vector<CornerEdge> brute_force(const dda::Model& model, const std::vector<Vec2>& vertices,
                                    double distance) {
    const dda::Topology& t = model.topology;
    const auto at = [&](dda::CornerIndex k) { return vertices[k]; };
    const auto free = [&](dda::BlockIndex block) { return model.motion[block] == Motion::free; };
    std::vector<CornerEdge> found;
    for (const dda::CornerIndex corner : t.corners()) {
        const Vec2 in = (at(corner) - at(t.previous[corner])).normalized();
        const Vec2 out = (at(t.next[corner]) - at(corner)).normalized();
        if (dda::cross(in, out) < -1e-3) continue;
        for (const dda::EdgeIndex edge : t.edges()) {
            const dda::BlockIndex a = t.block_of[corner];
            const dda::BlockIndex b = t.block_of_edge(edge);
            if (a == b || (!free(a) && !free(b))) continue;
            if (dda::distance_to_segment(at(corner), at(start_of(edge)), at(t.end_of(edge))) <= distance)
                found.push_back({corner, edge});
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

struct Shape {
    std::vector<Vec2> ring;
};
const std::vector<Shape> shapes = {
    {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},                    // square
    {{{0, 0}, {.5, 0}, {1, 0}, {1, 1}, {.5, 1}, {0, 1}}},  // with straight corners
    {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}},    // with a reflex corner
    {{{0, 0}, {8, 0}, {8, .05}, {0, .05}}},                // a long plate: its edges cross many cells
    {{{0, 0}, {.3, .1}, {.1, .3}}},                        // small and sharp
};

class RandomScenes : public testing::TestWithParam<unsigned> {};

TEST_P(RandomScenes, CandidatesAreThoseOfBruteForce) {
    std::mt19937 engine(GetParam());
    const auto draw = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
    };
    Scene s;
    for (int k = 0; k < 40; ++k) {
        const Shape& shape = shapes[engine() % shapes.size()];
        const double angle = k % 3 == 0 ? 0 : draw(0, 6.28);
        const Vec2 place(k % 3 == 0 ? std::floor(draw(-8, 8)) : draw(-8, 8), draw(-4, 4));
        std::vector<Vec2> ring;
        for (const Vec2& v : shape.ring) {
            ring.emplace_back(place + Vec2(std::cos(angle) * v.x() - std::sin(angle) * v.y(),
                                           std::sin(angle) * v.x() + std::cos(angle) * v.y()));
        }
        s.block({ring}, k % 5 == 0 ? Motion::fixed : k % 5 == 1 ? Motion::prescribed : Motion::free);
    }
    std::size_t found = 0;
    for (const double distance : {0.0, 1e-12, .01, .1, 1.0, 5.0}) {
        const auto expected = brute_force(s.model, s.model.vertices, distance);
        EXPECT_EQ(dda::find_candidates(s.model, s.model.vertices, distance), expected) << distance;
        found += expected.size();
    }
    EXPECT_GT(found, 1000u);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomScenes, testing::Range(1u, 13u), testing::PrintToStringParamName());

TEST(Candidates, OfNothingAreNone) {
    EXPECT_TRUE(dda::find_candidates(Scene().model, {}, 1).empty());
}

TEST(DistanceToSegment, BesideBeyondAndOfAPoint) {
    EXPECT_EQ(dda::distance_to_segment({1, 2}, {0, 0}, {4, 0}), 2);
    EXPECT_EQ(dda::distance_to_segment({7, 4}, {0, 0}, {4, 0}), 5);
    EXPECT_EQ(dda::distance_to_segment({-3, 4}, {0, 0}, {4, 0}), 5);
    EXPECT_EQ(dda::distance_to_segment({3, 4}, {0, 0}, {0, 0}), 5);
}

TEST(IsWithin, AgreesWithTheDistance) {
    RandomSource random(3);
    const auto point = [&] { return Vec2(random.between(-1, 1), random.between(-1, 1)); };
    for (int repetition = 0; repetition < 10000; ++repetition) {
        const Vec2 at = point(), first = point(), second = point();
        const double distance = dda::distance_to_segment(at, first, second);
        EXPECT_TRUE(dda::is_within(distance * (1 + 1e-12), at, first, second));
        EXPECT_FALSE(dda::is_within(distance * (1 - 1e-12), at, first, second));
    }
}

}  // namespace
}  // namespace rockslope::candidates_test
