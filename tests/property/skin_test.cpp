// Candidates are kept until a vertex has moved by half the skin. The contacts found among kept candidates
// must be bitwise those of a fresh search, and a search of all pairs must find no others.

#include <gtest/gtest.h>

#include "dda/contact/candidates.hpp"
#include "dda/contact/find_contacts.hpp"
#include "support/random_shapes.hpp"
#include "support/scene.hpp"

namespace rockslope::skin_test {
namespace {

using namespace scene;

constexpr double search_radius = 0.02;

/// Random blocks, close together.
Scene heap(RandomSource& random) {
    Scene s;
    for (int k = 0; k < 30; ++k) {
        const Vec2 place = random_point(random, 0, 2);
        s.block({random_ring_at(random, random.magnitude(.3, 2), place)});
    }
    s.friction(35);
    return s;
}

/// Shifts each block at random and rotates it about its first corner. @param largest m, bound of the shift
void stir(RandomSource& random, const dda::Topology& topology, double largest, std::vector<Vec2>& vertices) {
    for (const dda::BlockIndex b : topology.blocks()) {
        const Vec2 shift = random_point(random, 0, largest / 2);
        const double angle = random.between(-largest / 8, largest / 8);
        const Vec2 first = vertices[topology.block_corners[b]];
        for (const dda::CornerIndex k : topology.corners_of(b))
            vertices[k] = first + placed(vertices[k] - first, angle, shift);
    }
}

/// All data of a contact that detection and transfer set.
auto all_data(const dda::Contact& c) {
    return std::tuple(c.corner, c.edge, c.kind, c.joint_material, c.group, c.line, c.inhibited,
                      c.inherited_penetration, c.length, c.point.x(), c.point.y(), c.normal.x(), c.normal.y(),
                      c.gap, c.dilation, c.stress_free_gap, c.state, c.normal_force, c.shear_force, c.slip,
                      c.bonded);
}

class Skin : public ::testing::TestWithParam<unsigned> {};

TEST_P(Skin, FindsTheContactsOfAFreshSearch) {
    RandomSource random(GetParam());
    const Scene scene = heap(random);
    const ThreadPool pool(1);
    const double edge = dda::median_edge_length(scene.model.topology, scene.model.vertices);
    std::vector<Vec2> vertices = scene.model.vertices;
    dda::ContactSet last;
    int kept = 0;
    std::size_t contacts = 0;
    for (int step = 0; step < 60; ++step) {
        const dda::ContactSearch search{vertices, vertices, {}, search_radius, edge, 1e-9, 0.001, step == 0};
        dda::ContactSet without_candidates = last;
        without_candidates.reference.clear();
        const dda::ContactSet with_skin = dda::find_contacts(scene.model, last, search, pool).set;
        const dda::ContactSet fresh = dda::find_contacts(scene.model, without_candidates, search, pool).set;
        kept += step > 0 && with_skin.reference == last.reference ? 1 : 0;
        // A transferred contact is kept as long as it is a candidate. The two candidate sets may differ
        // beyond the search radius, where contacts are inhibited, so only contacts within it are compared.
        const auto within_search_radius = [&](const dda::ContactSet& set) {
            std::vector<decltype(all_data({}))> found;
            for (const dda::Contact& c : set.contacts) {
                const Vec2& end = vertices[scene.model.topology.end_of(c.edge)];
                if (dda::distance_to_segment(vertices[c.corner], vertices[start_of(c.edge)], end) <=
                    search_radius)
                    found.push_back(all_data(c));
            }
            return found;
        };
        const auto found = within_search_radius(with_skin);
        EXPECT_EQ(found, within_search_radius(fresh)) << "in step " << step;
        contacts += found.size();
        // All pairs within the search radius are among the kept candidates.
        for (const dda::CornerEdge& pair : dda::find_candidates(scene.model, vertices, search_radius))
            EXPECT_TRUE(std::binary_search(with_skin.candidates.begin(), with_skin.candidates.end(), pair));
        last = with_skin;
        stir(random, scene.model.topology, .05 * edge, vertices);
    }
    EXPECT_GT(kept, 20);
    EXPECT_LT(kept, 59);
    EXPECT_GT(contacts, 100u);
}

INSTANTIATE_TEST_SUITE_P(Heaps, Skin, ::testing::Range(1u, 13u));

}  // namespace
}  // namespace rockslope::skin_test
