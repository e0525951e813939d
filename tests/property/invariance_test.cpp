// Detected contacts must not depend on the order of the blocks, nor on position, orientation and units of the
// model.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "dda/contact/candidates.hpp"
#include "dda/contact/detect.hpp"
#include "support/random_shapes.hpp"
#include "support/scene.hpp"

namespace rockslope::invariance_test {
namespace {

using namespace scene;

/// Blocks as lists of rings, before they are transformed.
struct Shapes {
    std::vector<std::vector<Ring>> blocks;
    std::vector<dda::Motion> motion;
};

/// Random polygons that touch, overlap or are apart, some a hundred times smaller; neighbours with common
/// corners; a block with a hole and another one in it.
Shapes scattered(unsigned seed) {
    RandomSource random(seed);
    Shapes shapes;
    const auto add = [&](const std::vector<Ring>& rings) {
        shapes.blocks.push_back(rings);
        shapes.motion.push_back(random.index_below(5) == 0 ? dda::Motion::fixed : dda::Motion::free);
    };
    for (int k = 0; k < 24; ++k) {
        const double size = random.index_below(3) == 0 ? .02 : random.magnitude(.5, 2);
        const Vec2 place{random.between(-3, 3), random.between(-3, 3)};
        add({random_ring_at(random, size, place)});
    }
    // Quadrilaterals around common corners, which have exactly the same coordinates.
    const Vec2 centre{random.between(3, 4), random.between(3, 4)};
    Ring around;
    for (int k = 0; k < 5; ++k) {
        const double angle = 2 * std::numbers::pi * (k + random.between(0, .5)) / 5;
        around.push_back(centre + random.between(.5, 1) * Vec2(std::cos(angle), std::sin(angle)));
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

/// A change of orientation, position, units and order of the blocks.
struct Change {
    double angle = 0;
    Vec2 shift{0, 0};
    double metre = 1;  ///< units of length per metre
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

/// A corner or an edge: the index of its block among the shapes, and its own index in the block.
using Name = std::pair<std::size_t, int>;
struct ContactData {
    double gap = 0;
    double length = 0;
    dda::ContactKind kind = dda::ContactKind::vertex_edge;
    bool grouped = false;
    double edge = 0;    ///< m, length of the edge
    double inside = 0;  ///< m, distance of the corner's projection from the nearer end, positive on the edge
    Name end;           ///< the nearer end of the edge
    Vec2 normal{0, 0};  ///< transformed back
};
using Contacts = std::map<std::pair<Name, Name>, ContactData>;

/// The detected contacts, transformed back to the names, orientation and units of the shapes.
Contacts contacts_of(const Shapes& shapes, const Change& change, double search_radius) {
    const Scene s = built(shapes, change);
    const auto candidates = dda::find_candidates(s.model, s.model.vertices, 2 * search_radius * change.metre);
    const auto found = dda::detect_contacts(
        s.model, {s.model.vertices, s.model.vertices, search_radius * change.metre, 1e-9 * change.metre},
        candidates, ThreadPool(1));
    const auto name = [&](dda::CornerIndex corner) -> Name {
        const dda::BlockIndex b = s.model.topology.block_of[corner];
        return {change.order.empty() ? std::size_t{b} : change.order[b],
                corner - s.model.topology.block_corners[b]};
    };
    const auto at = [&](dda::CornerIndex corner) { return s.model.vertices[corner]; };
    Contacts contacts;
    for (const dda::Contact& c : found) {
        const dda::CornerIndex start = start_of(c.edge), end = s.model.topology.end_of(c.edge);
        const auto geometry = dda::corner_edge_geometry(at(c.corner), at(start), at(end));
        contacts[{name(c.corner), name(start)}] = {c.gap / change.metre,
                                                   c.length / change.metre,
                                                   c.kind,
                                                   c.group >= 0,
                                                   geometry.length / change.metre,
                                                   geometry.end_margin() / change.metre,
                                                   name(geometry.along < geometry.length / 2 ? start : end),
                                                   placed(c.normal, -change.angle, Vec2(0, 0))};
    }
    return contacts;
}

/// The error of a gap for coordinate errors of `rounding`, m: that of the corner and that of the line, which
/// grows with the distance beyond the ends of the edge.
double gap_tolerance(const ContactData& data, double rounding) {
    return rounding * (2 + 2 * std::max(0.0, -data.inside) / data.edge);
}

/// The error of a contact length, m: half the overlaps of up to four pairs of faces, each with an error of
/// twice the rounding at both ends.
double length_tolerance(double rounding) {
    return 8 * rounding;
}

/// Whether two contacts are on the same line at the same pair of corners, and these corners coincide up to
/// rounding. Either corner may then represent the line.
bool same_line_of_coinciding_corners(const Contacts::value_type& a, const Contacts::value_type& b,
                                     double rounding) {
    const auto corners = [](const Contacts::value_type& c) {
        return std::minmax(c.first.first, c.second.end);
    };
    return corners(a) == corners(b) && std::abs(a.second.inside) <= 4 * rounding &&
           std::abs(dda::cross(a.second.normal, b.second.normal)) <=
               4 * rounding / std::min(a.second.edge, b.second.edge);
}

/// Expects the same contacts, with gaps and lengths equal up to the propagated rounding errors.
void expect_same(const Contacts& one, const Contacts& other, double rounding) {
    EXPECT_EQ(one.size(), other.size());
    for (const auto& a : one) {
        auto b = other.find(a.first);
        if (b == other.end()) {
            b = std::find_if(other.begin(), other.end(), [&](const auto& candidate) {
                return same_line_of_coinciding_corners(a, candidate, rounding);
            });
        }
        const auto& [corner, edge] = a.first;
        ASSERT_NE(b, other.end()) << "corner " << corner.first << '.' << corner.second << ", edge "
                                  << edge.first << '.' << edge.second << ", inside " << a.second.inside;
        SCOPED_TRACE("corner " + std::to_string(corner.first) + '.' + std::to_string(corner.second) +
                     ", edge " + std::to_string(edge.first) + '.' + std::to_string(edge.second));
        EXPECT_NEAR(a.second.gap, b->second.gap, gap_tolerance(a.second, rounding));
        EXPECT_NEAR(a.second.length, b->second.length, length_tolerance(rounding));
        EXPECT_EQ(a.second.kind, b->second.kind);
        EXPECT_EQ(a.second.grouped, b->second.grouped);
    }
}

class DetectionInput : public testing::TestWithParam<unsigned> {
  protected:
    const Shapes shapes = scattered(GetParam());
    const double search_radius = RandomSource(GetParam() + 1000).magnitude(.003, .3);
    const Contacts plain = contacts_of(shapes, {}, search_radius);
    /// Rounding error of coordinates up to 8 m that are rotated and scaled, m: a few units in the last place.
    static constexpr double rounding = 8 * 4 * 2.2e-16;
};

TEST_P(DetectionInput, HasManyContacts) {
    EXPECT_GT(plain.size(), 10U);
}

TEST_P(DetectionInput, DoesNotDependOnUnits) {
    // A power of two scales without rounding; 1000 and 0.001 round.
    for (const double metre : {1024.0, 1000.0, .001}) {
        SCOPED_TRACE(metre);
        expect_same(plain, contacts_of(shapes, {0, {0, 0}, metre, {}}, search_radius), rounding);
    }
}

TEST_P(DetectionInput, DoesNotDependOnTheOrderOfTheBlocks) {
    RandomSource random(GetParam() + 2000);
    Change change;
    for (std::size_t k = 0; k < shapes.blocks.size(); ++k) change.order.push_back(k);
    for (int k = 0; k < 5; ++k) {
        for (std::size_t b = change.order.size(); b > 1; --b)
            std::swap(change.order[b - 1], change.order[random.index_below(static_cast<unsigned>(b))]);
        expect_same(plain, contacts_of(shapes, change, search_radius), 0x1p-50);
    }
}

TEST_P(DetectionInput, DoesNotDependOnTheOrientationOfTheModel) {
    RandomSource random(GetParam() + 3000);
    for (int k = 0; k < 5; ++k) {
        const Vec2 shift{random.between(-5, 5), random.between(-5, 5)};
        expect_same(plain, contacts_of(shapes, {random.between(0, 6), shift, 1, {}}, search_radius),
                    2 * rounding);
    }
}

TEST_P(DetectionInput, DoesNotDependOnThePositionOfTheModel) {
    // Coordinates of 1e6 m are rounded to the half of 2^-33 m, in x and in y.
    const double far_rounding = 0x1p-33 / std::sqrt(2.0);
    for (const Vec2& shift : {Vec2(1e6, 0), Vec2(-1e6, 1e6), Vec2(1e6 / 3, -1e6 / 7)}) {
        SCOPED_TRACE(shift.transpose());
        expect_same(plain, contacts_of(shapes, {0, shift, 1, {}}, search_radius), far_rounding);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, DetectionInput, testing::Range(1U, 21U), testing::PrintToStringParamName());

}  // namespace
}  // namespace rockslope::invariance_test
