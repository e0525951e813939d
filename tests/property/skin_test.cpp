// Candidates are kept while nothing has moved half the skin. What is found among the kept ones must be what
// is found among those of the moment, to the last bit, and a search of all pairs must find no more.

#include <gtest/gtest.h>

#include "dda/contact/candidates.hpp"
#include "dda/contact/find_contacts.hpp"
#include "support/random_shapes.hpp"

using namespace rockslope;

namespace {

using namespace scene;

constexpr double search_radius = 0.02;

/// Blocks of all kinds, close together.
Scene heap(RandomSource& random) {
    Scene s;
    for (int k = 0; k < 30; ++k)
        s.block({placed(random_ring(random, random.magnitude(.3, 2)), random.between(0, 6),
                        random.between(0, 2) * random.direction())});
    s.friction(35);
    return s;
}

/// Each block shifted at random by no more than that, m, and turned about its first corner by some of it.
void stir(RandomSource& random, const dda::Topology& topology, double most, std::vector<Vec2>& vertices) {
    for (std::size_t b = 0; b + 1 < topology.block_corners.size(); ++b) {
        const Vec2 shift = random.between(0, most / 2) * random.direction();
        const double angle = random.between(-most / 8, most / 8);
        const auto begin = static_cast<std::size_t>(topology.block_corners[b]);
        const auto end = static_cast<std::size_t>(topology.block_corners[b + 1]);
        const Vec2 first = vertices[begin];
        for (std::size_t k = begin; k < end; ++k)
            vertices[k] = first + placed(vertices[k] - first, angle, shift);
    }
}

/// What tells contacts apart, with every number that detection and transfer give them.
auto all_of(const dda::Contact& c) {
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
        dda::ContactSet forgetful = last;
        forgetful.reference.clear();
        const dda::ContactSet with_skin = dda::find_contacts(scene.model, last, search, pool).set;
        const dda::ContactSet anew = dda::find_contacts(scene.model, forgetful, search, pool).set;
        kept += step > 0 && with_skin.reference == last.reference ? 1 : 0;
        // A contact of before stays while it is a candidate, and of those the older set may have others:
        // beyond the search_radius, where they are held back.
        const auto within_reach = [&](const dda::ContactSet& set) {
            std::vector<decltype(all_of({}))> found;
            for (const dda::Contact& c : set.contacts) {
                const auto at = [&](int corner) { return vertices[static_cast<std::size_t>(corner)]; };
                const int end = scene.model.topology.next[static_cast<std::size_t>(c.edge)];
                if (dda::distance_to_segment(at(c.corner), at(c.edge), at(end)) <= search_radius)
                    found.push_back(all_of(c));
            }
            return found;
        };
        const auto found = within_reach(with_skin);
        EXPECT_EQ(found, within_reach(anew)) << "in step " << step;
        contacts += found.size();
        // All that are within search_radius are among the kept ones.
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
