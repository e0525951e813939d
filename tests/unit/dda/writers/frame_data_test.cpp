#include "dda/writers/frame_data.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::frame_data_test {
namespace {

using namespace scene;

/// End points of the line that shows the only contact.
std::pair<Vec2, Vec2> drawn(Scene& s, int corner, int edge, double length) {
    dda::State state;
    state.blocks = dda::initial_block_system(s.model);
    dda::Contact contact;
    contact.corner = corner;
    contact.edge = edge;
    contact.length = length;
    const auto at = [&](dda::CornerIndex k) { return s.model.vertices[k]; };
    contact.tangent = (at(s.model.topology.next[edge]) - at(edge)).normalized();
    state.contacts.contacts.push_back(contact);
    const dda::GridFrame frame = dda::contact_frame(s.model, state);
    EXPECT_EQ(frame.points.size(), 6U);
    return {{frame.points[0], frame.points[1]}, {frame.points[3], frame.points[4]}};
}

// Two boxes. The upper one, 2 m wide, lies on the right end of the lower one's top, which runs from corner 2
// at (6, 1) to corner 3 at (0, 1).
Scene boxes(double right) {
    Scene s;
    s.box({0, 0}, 6, 1);
    s.box({right - 2, 1}, 2, 1);
    return s;
}

TEST(ContactFrame, DrawsTheContactLengthAlongTheCornersFace) {
    Scene s = boxes(5.5);
    const auto left = drawn(s, 4, 2, 1);
    EXPECT_NEAR((left.first - Vec2(3.5, 1)).norm(), 0, 1e-12);
    EXPECT_NEAR((left.second - Vec2(4.5, 1)).norm(), 0, 1e-12)
        << "to the right, though the edge is longer to the left";
    const auto right = drawn(s, 5, 2, 1);
    EXPECT_NEAR((right.second - Vec2(4.5, 1)).norm(), 0, 1e-12);
}

TEST(ContactFrame, DrawsNoLengthBeyondTheEdgesEnd) {
    Scene s = boxes(7.5);
    const auto left = drawn(s, 4, 2, .9);
    EXPECT_NEAR((left.second - Vec2(6, 1)).norm(), 0, 1e-12) << "the edge ends half a metre from the corner";
}

}  // namespace
}  // namespace rockslope::frame_data_test
