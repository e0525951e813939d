// The detector against one that knows no grid, no groups and no vectors, but looks at all pairs and angles.

#include <gtest/gtest.h>

#include <algorithm>

#include "dda/contact/candidates.hpp"
#include "dda/contact/detect.hpp"
#include "support/random_shapes.hpp"

using namespace rockslope;

namespace {

using namespace scene;

/// Blocks of all kinds in a heap, every fifth fixed: overlapping, apart, a hundred times smaller ones among
/// them, some of them a thousand times as far away as they are large.
Scene heap(unsigned seed) {
    RandomSource random(seed);
    Scene s;
    const double spread = random.magnitude(1, 3);
    for (int k = 0; k < 40; ++k) {
        const double size = random.index_below(3) == 0 ? .02 : random.magnitude(.3, 2);
        const double away = random.index_below(10) == 0 ? 20 : 1;
        const Vec2 place = away * spread * random.between(0, 1) * random.direction();
        s.block({placed(random_ring(random, size), random.between(0, 6), place)},
                random.index_below(5) == 0 ? dda::Motion::fixed : dda::Motion::free);
    }
    return s;
}

/// What of a scene is where.
class Places {
  public:
    explicit Places(const dda::Model& model) : model_(model), topology_(model.topology) {}

    const Vec2& at(int corner) const { return model_.vertices[static_cast<std::size_t>(corner)]; }
    int next(int corner) const { return topology_.next[static_cast<std::size_t>(corner)]; }
    int previous(int corner) const { return topology_.previous[static_cast<std::size_t>(corner)]; }
    Vec2 normal(int edge) const { return -dda::perpendicular(at(next(edge)) - at(edge)).normalized(); }

    /// All pairs of a corner and an edge of different blocks that are not both fixed.
    std::vector<dda::CornerEdge> pairs() const {
        std::vector<dda::CornerEdge> all;
        for (int corner = 0; corner < topology_.corner_count(); ++corner) {
            for (int edge = 0; edge < topology_.corner_count(); ++edge) {
                const int block = topology_.block_of[static_cast<std::size_t>(corner)];
                const int other = topology_.block_of[static_cast<std::size_t>(edge)];
                if (block != other && (is_free(block) || is_free(other))) all.push_back({corner, edge});
            }
        }
        return all;
    }

    /// The least of the distances to the ends and, where it meets the edge, along the perpendicular, m.
    double distance(const dda::CornerEdge& pair) const {
        const Vec2 from = at(pair.edge) - at(pair.corner);
        const Vec2 to = at(next(pair.edge)) - at(pair.corner);
        const Vec2 along = to - from;
        const double ends = std::min(std::hypot(from.x(), from.y()), std::hypot(to.x(), to.y()));
        if (from.dot(along) > 0 || to.dot(along) < 0) return ends;
        return std::min(ends, std::abs(dda::cross(from, to)) / along.norm());
    }

    /// The angle of rock at a corner, rad.
    double rock_angle(int corner) const {
        const double angle = direction(at(previous(corner)) - at(corner)) - first_direction(corner);
        return angle > 0 ? angle : angle + 2 * std::numbers::pi;
    }

    /// How far below a line with this normal any direction in the rock at a corner points, as a sine: 1 where
    /// one points straight down.
    double deepest_direction(int corner, const Vec2& normal) const {
        const double first = first_direction(corner);
        const double last = first + rock_angle(corner);
        double down = direction(-normal);
        while (down < first) down += 2 * std::numbers::pi;
        if (down <= last) return 1;
        return std::max(std::cos(down - last), std::cos(down - 2 * std::numbers::pi - first));
    }

    /// Whether the middle of the rock at a corner is on the outer side of a line with this normal: what tells
    /// the sides apart for a straight corner, and for a tip that is sharper than the tolerance.
    bool is_outside(int corner, const Vec2& normal) const {
        return std::cos(first_direction(corner) + rock_angle(corner) / 2 - direction(normal)) > 0;
    }

  private:
    static double direction(const Vec2& v) { return std::atan2(v.y(), v.x()); }
    double first_direction(int corner) const { return direction(at(next(corner)) - at(corner)); }
    bool is_free(int block) const {
        return model_.motion[static_cast<std::size_t>(block)] == dda::Motion::free;
    }

    const dda::Model& model_;
    const dda::Topology& topology_;
};

class Detector : public testing::TestWithParam<unsigned> {
  protected:
    const Scene scene = heap(GetParam());
    const dda::Model& model = scene.model;
    const Places places{model};
    const double reach = RandomSource(GetParam() + 1000).magnitude(.01, .5);

    std::vector<dda::Contact> detected(const std::vector<dda::CornerEdge>& pairs) const {
        return dda::detect_contacts(model, {model.vertices, model.vertices, reach, 1e-9}, pairs,
                                    ThreadPool(1));
    }
};

TEST_P(Detector, FindsTheCandidatesOfABruteForceSearch) {
    for (const double distance : {0.0, .3 * reach, reach, 2 * reach, 2.0, 200.0}) {
        std::vector<dda::CornerEdge> expected;
        for (const dda::CornerEdge& pair : places.pairs()) {
            const bool reflex = places.rock_angle(pair.corner) > std::numbers::pi + std::asin(1e-3);
            if (!reflex && places.distance(pair) <= distance) expected.push_back(pair);
        }
        EXPECT_EQ(dda::find_candidates(model, model.vertices, distance), expected) << "distance " << distance;
    }
}

TEST_P(Detector, FindsTheSameContactsAmongAllPairs) {
    const auto all = detected(places.pairs());
    const auto near = detected(dda::find_candidates(model, model.vertices, reach));
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

// A pair within reach whose rock is on the outer side is a contact, or where the corner is near an end of the
// edge, a contact of that pair of corners stands for its line; and nothing else is a contact.
TEST_P(Detector, FindsWhatCanTouch) {
    const auto contacts = detected(places.pairs());
    ASSERT_GT(contacts.size(), 0U);
    const auto can_touch = [&](const dda::CornerEdge& pair) {
        return places.distance(pair) <= reach && places.is_outside(pair.corner, places.normal(pair.edge)) &&
               places.deepest_direction(pair.corner, places.normal(pair.edge)) <= dda::parallel_tolerance;
    };
    for (const dda::Contact& c : contacts)
        EXPECT_TRUE(can_touch({c.corner, c.edge})) << "corner " << c.corner << ", edge " << c.edge;
    const auto near_end = [&](int corner, int edge) {
        const int next = places.next(edge);
        const bool first = (places.at(corner) - places.at(edge)).squaredNorm() <
                           (places.at(corner) - places.at(next)).squaredNorm();
        return first ? edge : next;
    };
    const auto corners_of = [&](int corner, int edge) -> std::pair<int, int> {
        return std::minmax({corner, near_end(corner, edge)});
    };
    const auto is_contact = [&](const dda::CornerEdge& pair) {
        return std::any_of(contacts.begin(), contacts.end(), [&](const dda::Contact& c) {
            return c.corner == pair.corner && c.edge == pair.edge;
        });
    };
    const auto is_stood_for = [&](const dda::CornerEdge& pair) {
        const auto corners = corners_of(pair.corner, pair.edge);
        return std::any_of(contacts.begin(), contacts.end(), [&](const dda::Contact& c) {
            return corners_of(c.corner, c.edge) == corners &&
                   std::abs(dda::cross(c.normal, places.normal(pair.edge))) < dda::parallel_tolerance;
        });
    };
    for (const dda::CornerEdge& pair : places.pairs()) {
        if (!can_touch(pair)) continue;
        const int end = near_end(pair.corner, pair.edge);
        const bool grouped = (places.at(pair.corner) - places.at(end)).norm() <= reach &&
                             places.rock_angle(end) <= std::numbers::pi + std::asin(dda::parallel_tolerance);
        EXPECT_TRUE(is_contact(pair) || (grouped && is_stood_for(pair)))
            << "corner " << pair.corner << ", edge " << pair.edge;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Detector, testing::Range(1U, 31U), testing::PrintToStringParamName());

}  // namespace
