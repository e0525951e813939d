#include "blockgen/fit/read_joint_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/blockgen/file_folder.hpp"

namespace rockslope::blockgen::read_joint_map_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

class MapToFit : public FileFolder {};

// Twice, also to and fro and with a vertex on the way: one joint, which is told.
TEST_F(MapToFit, TracesDigitisedTwiceAreOne) {
    file("map.geojson", R"({"type": "MultiLineString", "coordinates": [
        [[0, 0], [10, 10]], [[0, 8], [6, 8]], [[10, 10], [0, 0]], [[0, 8], [2, 8], [6, 8]], [[1, 0], [1, 9]]]})");
    MapRequest request;
    request.traces = folder_ / "map.geojson";
    request.crs = "local";
    const JointMapFile read = read_joint_map(request);
    EXPECT_EQ(read.map.traces.size(), 3u);
    EXPECT_THAT(read.notes, Contains(HasSubstr("2 ")));
}

}  // namespace
}  // namespace rockslope::blockgen::read_joint_map_test
