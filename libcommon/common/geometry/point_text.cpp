#include "common/geometry/point_text.hpp"

#include "common/base/text.hpp"

namespace rockslope {

std::string text_of(const Point& p) {
    return "(" + shortest_text(p.x) + ", " + shortest_text(p.y) + ")";
}

}  // namespace rockslope
