#include "dda/path/limited_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "support/random_shapes.hpp"

namespace rockslope::limited_contact_test {
namespace {

using rockslope::dda::Border;
using rockslope::dda::ElasticForces;
using rockslope::dda::LimitedContact;
using rockslope::dda::Piece;
using rockslope::dda::Vec2;
using rockslope::scene::RandomSource;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Contacts of each kind: friction, cohesion, a tilted spring, unequal bounds, bounds that harden, bonds that
/// hold or break.
std::vector<LimitedContact> kinds() {
    LimitedContact friction;
    friction.forward = friction.backward = {0, 0.7};
    LimitedContact cohesive = friction;
    cohesive.forward.cohesion = cohesive.backward.cohesion = 3;
    LimitedContact tilted = friction;
    tilted.tilt = 0.3;
    LimitedContact steep = friction;
    steep.tilt = 1.1;
    LimitedContact unequal = tilted;
    unequal.forward.slope = 0.9;
    LimitedContact hardening = unequal;
    hardening.hardening = {0.4, 0.15};
    LimitedContact held = cohesive;
    held.least_normal = held.floor = -2;
    LimitedContact breakable = cohesive;
    breakable.least_normal = -infinite;
    breakable.floor = -3 / 0.7;
    LimitedContact weak = cohesive;
    weak.least_normal = -8;
    weak.floor = -3 / 0.7;
    return {friction, cohesive, tilted, steep, unequal, hardening, held, breakable, weak};
}

/// The forces by the laws themselves.
Vec2 by_laws(const LimitedContact& c, const ElasticForces& elastic) {
    const double normal = std::max(elastic.normal, c.least_normal);
    const double at = std::max(normal, c.floor);
    const double by_tilt = c.tilt * normal;
    const double most = std::max(c.forward.at(at), 0.0) - by_tilt;
    const double least = -std::max(c.backward.at(at), 0.0) - by_tilt;
    return {normal, std::clamp(elastic.shear, least, most) +
                        c.hardening.forward * std::max(elastic.shear - most, 0.0) +
                        c.hardening.backward * std::min(elastic.shear - least, 0.0)};
}

Vec2 by_pieces(const LimitedContact& c, const ElasticForces& elastic) {
    return c.on(c.piece_at(elastic)).at(elastic);
}

/// Elastic forces within a few times the cohesion, some of them on a border.
ElasticForces random_forces(RandomSource& random) {
    ElasticForces elastic{random.between(-12, 12), random.between(-12, 12)};
    if (random.index_below(8) == 0) elastic.normal = 0;
    if (random.index_below(8) == 0) elastic.shear = 0;
    return elastic;
}

TEST(LimitedContact, HasTheForcesOfItsLaws) {
    RandomSource random(1);
    for (const LimitedContact& c : kinds()) {
        for (int repetition = 0; repetition < 2000; ++repetition) {
            const ElasticForces elastic = random_forces(random);
            EXPECT_LT((by_pieces(c, elastic) - by_laws(c, elastic)).norm(), 1e-12) << "rounding";
        }
    }
}

/// Walks from one pair of elastic forces to another by the borders.
TEST(LimitedContact, PassesFromPieceToPieceByItsBorders) {
    RandomSource random(2);
    for (const LimitedContact& c : kinds()) {
        for (int repetition = 0; repetition < 2000; ++repetition) {
            const ElasticForces from = random_forces(random), to = random_forces(random);
            const ElasticForces rate{to.normal - from.normal, to.shear - from.shear};
            const auto at = [&](double way) {
                return ElasticForces{from.normal + way * rate.normal, from.shear + way * rate.shear};
            };
            Piece piece = c.piece_at(from);
            double way = 0;
            int borders = 0;
            for (; borders < 10; ++borders) {
                const Border border = c.first_border(piece, at(way), rate);
                if (way + border.distance >= 1) break;
                way += border.distance;
                EXPECT_LT((c.on(piece).at(at(way)) - c.on(border.beyond).at(at(way))).norm(), 1e-11)
                    << "the forces do not jump";
                const Eigen::Matrix2d change = c.on(border.beyond).slope - c.on(piece).slope;
                EXPECT_LT((change * Vec2(-border.normal.y(), border.normal.x())).norm(), 1e-12)
                    << "along the border the forces change as before";
                piece = border.beyond;
            }
            EXPECT_LT(borders, 10) << "the way ends";
            EXPECT_LT((c.on(piece).at(to) - by_laws(c, to)).norm(), 1e-9) << "rounding at a border";
        }
    }
}

TEST(LimitedContact, BearsNothingWhereItMayNotClose) {
    LimitedContact c;
    c.may_close = false;
    EXPECT_EQ(by_pieces(c, {5, 1}), Vec2::Zero());
    EXPECT_EQ(c.first_border(c.piece_at({5, 1}), {5, 1}, {-1, 0}).distance, infinite);
}

}  // namespace
}  // namespace rockslope::limited_contact_test
