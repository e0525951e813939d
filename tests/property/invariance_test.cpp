// What must not matter: the order of the blocks, where the model is, which way it is turned, its units.

#include <gtest/gtest.h>

#include <map>

#include "dda/contact/candidates.hpp"
#include "dda/contact/detect.hpp"
#include "support/random_shapes.hpp"

namespace {

using namespace scene;

/// Blocks as lists of rings, before they are anywhere.
struct Shapes {
    std::vector<std::vector<Ring>> blocks;
    std::vector<dda::Motion> motion;
};

/// Polygons of all kinds scattered so that they touch, overlap and stand apart, a hundred times smaller ones
/// among them; neighbours with common corners; a block with a hole and one in it.
Shapes scattered(unsigned seed) {
    Dice dice(seed);
    Shapes shapes;
    const auto add = [&](const std::vector<Ring>& rings) {
        shapes.blocks.push_back(rings);
        shapes.motion.push_back(dice.one_of(5) == 0 ? dda::Motion::fixed : dda::Motion::free);
    };
    for (int k = 0; k < 24; ++k) {
        const double size = dice.one_of(3) == 0 ? .02 : dice.magnitude(.5, 2);
        const Vec2 place(dice.between(-3, 3), dice.between(-3, 3));
        add({placed(random_ring(dice, size), dice.between(0, 6), place)});
    }
    // Quadrilaterals around common corners, which rounding puts in one place.
    const Vec2 centre(dice.between(3, 4), dice.between(3, 4));
    Ring around;
    for (int k = 0; k < 5; ++k) {
        const double angle = 2 * std::numbers::pi * (k + dice.between(0, .5)) / 5;
        around.push_back(centre + dice.between(.5, 1) * Vec2(std::cos(angle), std::sin(angle)));
    }
    for (std::size_t k = 0; k < 5; ++k) {
        const Vec2& a = around[k];
        const Vec2& b = around[(k + 1) % 5];
        add({{centre, a, (a + b) / 2, b}});  // a straight corner on the outside
    }
    add({{{-6, -1}, {-4, -1}, {-4, 1}, {-6, 1}}, {{-5.5, -.5}, {-5.5, .5}, {-4.5, .5}, {-4.5, -.5}}});
    add({{{-5.5, -.5}, {-4.9, -.5}, {-4.9, .1}, {-5.5, .1}}});
    return shapes;
}

/// How a model differs from another: what of each block is where.
struct Change {
    double angle = 0;
    Vec2 shift{0, 0};
    double metre = 1;  ///< how many units of length a metre is
    std::vector<std::size_t> order;
};

Scene built(const Shapes& shapes, const Change& change = {}) {
    Scene s;
    for (std::size_t k = 0; k < shapes.blocks.size(); ++k) {
        const std::size_t block = change.order.empty() ? k : change.order[k];
        std::vector<Ring> rings;
        for (const Ring& ring : shapes.blocks[block]) {
            rings.push_back(placed(ring, change.angle, change.shift));
            for (Vec2& v : rings.back()) v *= change.metre;
        }
        s.block(rings, shapes.motion[block]);
    }
    return s;
}

/// A corner or an edge by its block's number among the shapes and its own in the block.
using Name = std::pair<std::size_t, int>;
struct Told {
    double gap = 0;
    double length = 0;
    dda::ContactKind kind = dda::ContactKind::vertex_edge;
    bool grouped = false;
};
using Contacts = std::map<std::pair<Name, Name>, Told>;

/// The contacts found, in the shapes' names, the model's angles and metres.
Contacts contacts_of(const Shapes& shapes, const Change& change, double reach) {
    const Scene s = built(shapes, change);
    const auto candidates = dda::find_candidates(s.model, s.model.vertices, 2 * reach * change.metre);
    const auto found = dda::detect_contacts(
        s.model, {s.model.vertices, s.model.vertices, reach * change.metre, 1e-9 * change.metre}, candidates,
        dda::Crew(1));
    const auto name = [&](int corner) -> Name {
        const int block = s.model.topology.block_of[static_cast<std::size_t>(corner)];
        const auto b = static_cast<std::size_t>(block);
        return {change.order.empty() ? b : change.order[b], corner - s.model.topology.block_corners[b]};
    };
    Contacts contacts;
    for (const dda::Contact& c : found) {
        contacts[{name(c.corner), name(c.edge)}] = {c.gap / change.metre, c.length / change.metre, c.kind,
                                                    c.group >= 0};
    }
    return contacts;
}

void expect_same(const Contacts& one, const Contacts& other, double tolerance) {
    ASSERT_EQ(one.size(), other.size());
    for (auto a = one.begin(), b = other.begin(); a != one.end(); ++a, ++b) {
        ASSERT_EQ(a->first, b->first) << "corner " << a->first.first.first << '.' << a->first.first.second;
        EXPECT_NEAR(a->second.gap, b->second.gap, tolerance);
        EXPECT_NEAR(a->second.length, b->second.length, tolerance);
        EXPECT_EQ(a->second.kind, b->second.kind);
        EXPECT_EQ(a->second.grouped, b->second.grouped);
    }
}

class Detection : public testing::TestWithParam<unsigned> {
  protected:
    const Shapes shapes = scattered(GetParam());
    const double reach = Dice(GetParam() + 1000).magnitude(.003, .3);
    const Contacts plain = contacts_of(shapes, {}, reach);
};

TEST_P(Detection, FindsSomething) {
    EXPECT_GT(plain.size(), 10U);
}

TEST_P(Detection, DoesNotDependOnUnits) {
    // A power of two changes no bit; a thousand rounds. Gaps of 1e-16 m may then differ by as much.
    for (const double metre : {1024.0, 1000.0, .001})
        expect_same(plain, contacts_of(shapes, {0, {0, 0}, metre, {}}, reach), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Detection, testing::Range(1U, 21U), testing::PrintToStringParamName());

}  // namespace
