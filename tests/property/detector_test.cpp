// Contact detection against a brute-force reference that tests all pairs by angles, without grid and groups.

#include <gtest/gtest.h>

#include <algorithm>

#include "dda/contact/candidates.hpp"
#include "dda/contact/detect.hpp"
#include "support/random_shapes.hpp"
#include "support/scene.hpp"

namespace rockslope::detector_test {
namespace {

using namespace scene;

/// Random blocks in a heap, a fifth of them fixed. They overlap or are apart, some are a hundred times
/// smaller, and some are a thousand times their size away.
Scene heap(unsigned seed) {
    RandomSource random(seed);
    Scene s;
    const double spread = random.magnitude(1, 3);
    for (int k = 0; k < 40; ++k) {
        const double size = random.index_below(3) == 0 ? .02 : random.magnitude(.3, 2);
        const double away = random.index_below(10) == 0 ? 20 : 1;
        const Vec2 place = away * spread * random_point(random, 0, 1);
        const bool is_fixed = random.index_below(5) == 0;
        s.block({random_ring_at(random, size, place)}, is_fixed ? dda::Motion::fixed : dda::Motion::free);
    }
    return s;
}

/// The geometry of a model by angles and distances.
class Geometry {
  public:
    explicit Geometry(const dda::Model& model) : model_(model), topology_(model.topology) {}

    const Vec2& at(dda::CornerIndex corner) const { return model_.vertices[corner]; }
    const Vec2& start(dda::EdgeIndex edge) const { return at(start_of(edge)); }
    const Vec2& end(dda::EdgeIndex edge) const { return at(topology_.end_of(edge)); }
    dda::CornerIndex end_of(dda::EdgeIndex edge) const { return topology_.end_of(edge); }
    dda::CornerIndex next(dda::CornerIndex corner) const { return topology_.next[corner]; }
    dda::CornerIndex previous(dda::CornerIndex corner) const { return topology_.previous[corner]; }
    Vec2 normal(dda::EdgeIndex edge) const {
        return -dda::perpendicular(end(edge) - start(edge)).normalized();
    }

    /// All pairs of a corner and an edge of different blocks that are not both fixed.
    std::vector<dda::CornerEdge> pairs() const {
        std::vector<dda::CornerEdge> all;
        for (const dda::CornerIndex corner : topology_.corners()) {
            for (const dda::EdgeIndex edge : topology_.edges()) {
                const dda::BlockIndex block = topology_.block_of[corner];
                const dda::BlockIndex other = topology_.block_of_edge(edge);
                if (block != other && (is_free(block) || is_free(other))) all.push_back({corner, edge});
            }
        }
        return all;
    }

    /// The distance from a corner to an edge, m: to the nearer end, or along the perpendicular if that meets
    /// the edge.
    double distance(const dda::CornerEdge& pair) const {
        const Vec2 from = start(pair.edge) - at(pair.corner);
        const Vec2 to = end(pair.edge) - at(pair.corner);
        const Vec2 along = to - from;
        const double ends = std::min(std::hypot(from.x(), from.y()), std::hypot(to.x(), to.y()));
        if (from.dot(along) > 0 || to.dot(along) < 0) return ends;
        return std::min(ends, std::abs(dda::cross(from, to)) / along.norm());
    }

    /// The interior angle of a corner, rad.
    double rock_angle(dda::CornerIndex corner) const {
        const double angle = direction(at(previous(corner)) - at(corner)) - first_direction(corner);
        return angle > 0 ? angle : angle + 2 * std::numbers::pi;
    }

    /// The largest sine of the angle by which a direction inside the corner points below a line with this
    /// normal; 1 if one points along -normal.
    double deepest_direction(dda::CornerIndex corner, const Vec2& normal) const {
        const double first = first_direction(corner);
        const double last = first + rock_angle(corner);
        double down = direction(-normal);
        while (down < first) down += 2 * std::numbers::pi;
        if (down <= last) return 1;
        return std::max(std::cos(down - last), std::cos(down - 2 * std::numbers::pi - first));
    }

    /// Whether the bisector of a corner is on the outer side of a line with this normal. This decides the
    /// side of a straight corner and of a tip sharper than the tolerance.
    bool is_outside(dda::CornerIndex corner, const Vec2& normal) const {
        return std::cos(first_direction(corner) + rock_angle(corner) / 2 - direction(normal)) > 0;
    }

  private:
    static double direction(const Vec2& v) { return std::atan2(v.y(), v.x()); }
    double first_direction(dda::CornerIndex corner) const { return direction(at(next(corner)) - at(corner)); }
    bool is_free(dda::BlockIndex block) const { return model_.motion[block] == dda::Motion::free; }

    const dda::Model& model_;
    const dda::Topology& topology_;
};

class Detector : public testing::TestWithParam<unsigned> {
  protected:
    const Scene scene = heap(GetParam());
    const dda::Model& model = scene.model;
    const Geometry geometry{model};
    const double search_radius = RandomSource(GetParam() + 1000).magnitude(.01, .5);

    std::vector<dda::Contact> detected(const std::vector<dda::CornerEdge>& pairs) const {
        return dda::detect_contacts(model, {model.vertices, model.vertices, search_radius, 1e-9}, pairs,
                                    ThreadPool(1));
    }
};

TEST_P(Detector, FindsTheCandidatesOfABruteForceSearch) {
    for (const double distance : {0.0, .3 * search_radius, search_radius, 2 * search_radius, 2.0, 200.0}) {
        std::vector<dda::CornerEdge> expected;
        for (const dda::CornerEdge& pair : geometry.pairs()) {
            const bool reflex = geometry.rock_angle(pair.corner) > std::numbers::pi + std::asin(1e-3);
            if (!reflex && geometry.distance(pair) <= distance) expected.push_back(pair);
        }
        EXPECT_EQ(dda::find_candidates(model, model.vertices, distance), expected) << "distance " << distance;
    }
}

TEST_P(Detector, FindsTheSameContactsAmongAllPairs) {
    const auto all = detected(geometry.pairs());
    const auto near = detected(dda::find_candidates(model, model.vertices, search_radius));
    ASSERT_GT(all.size(), 0U);
    ASSERT_EQ(all.size(), near.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        EXPECT_EQ(all[k].corner, near[k].corner);
        EXPECT_EQ(all[k].edge, near[k].edge);
        EXPECT_EQ(all[k].gap, near[k].gap);
        EXPECT_EQ(all[k].length, near[k].length);
        EXPECT_EQ(all[k].kind, near[k].kind);
        EXPECT_EQ(all[k].group, near[k].group);
        EXPECT_EQ(all[k].line, near[k].line);
    }
}

// Every pair within the search radius that can touch is a contact. If the corner is near an end of the edge,
// another contact on the same line of that pair of corners may represent it. No other pair is a contact.
TEST_P(Detector, FindsExactlyThePairsThatCanTouch) {
    const auto contacts = detected(geometry.pairs());
    ASSERT_GT(contacts.size(), 0U);
    const auto can_touch = [&](const dda::CornerEdge& pair) {
        return geometry.distance(pair) <= search_radius &&
               geometry.is_outside(pair.corner, geometry.normal(pair.edge)) &&
               geometry.deepest_direction(pair.corner, geometry.normal(pair.edge)) <= dda::parallel_tolerance;
    };
    for (const dda::Contact& c : contacts)
        EXPECT_TRUE(can_touch({c.corner, c.edge})) << "corner " << c.corner << ", edge " << c.edge;
    const auto near_end = [&](dda::CornerIndex corner, dda::EdgeIndex edge) {
        const bool first = (geometry.at(corner) - geometry.start(edge)).squaredNorm() <
                           (geometry.at(corner) - geometry.end(edge)).squaredNorm();
        return first ? start_of(edge) : geometry.end_of(edge);
    };
    const auto corners_of = [&](dda::CornerIndex corner,
                                dda::EdgeIndex edge) -> std::pair<dda::CornerIndex, dda::CornerIndex> {
        return std::minmax({corner, near_end(corner, edge)});
    };
    const auto is_contact = [&](const dda::CornerEdge& pair) {
        return std::any_of(contacts.begin(), contacts.end(), [&](const dda::Contact& c) {
            return c.corner == pair.corner && c.edge == pair.edge;
        });
    };
    const auto is_represented = [&](const dda::CornerEdge& pair) {
        const auto corners = corners_of(pair.corner, pair.edge);
        return std::any_of(contacts.begin(), contacts.end(), [&](const dda::Contact& c) {
            return corners_of(c.corner, c.edge) == corners &&
                   std::abs(dda::cross(c.normal, geometry.normal(pair.edge))) < dda::parallel_tolerance;
        });
    };
    for (const dda::CornerEdge& pair : geometry.pairs()) {
        if (!can_touch(pair)) continue;
        const dda::CornerIndex end = near_end(pair.corner, pair.edge);
        const bool grouped =
            (geometry.at(pair.corner) - geometry.at(end)).norm() <= search_radius &&
            geometry.rock_angle(end) <= std::numbers::pi + std::asin(dda::parallel_tolerance);
        EXPECT_TRUE(is_contact(pair) || (grouped && is_represented(pair)))
            << "corner " << pair.corner << ", edge " << pair.edge;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Detector, testing::Range(1U, 31U), testing::PrintToStringParamName());

}  // namespace
}  // namespace rockslope::detector_test
