#include "common/geometry/vertical_sections.hpp"

#include <algorithm>

namespace rockslope {

VerticalSections::VerticalSections(const std::vector<Ring>& rings) {
    for (const Ring& ring : rings) {
        const double turn = twice_signed_area(ring) < 0 ? -1 : 1;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
            corners_.push_back(a.x);
            if (a.x < b.x) edges_.push_back({a, b, -turn});
            if (a.x > b.x) edges_.push_back({b, a, turn});
        }
    }
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    buckets_.resize(std::max<std::size_t>(1, edges_.size()));
    for (std::size_t k = 0; k < edges_.size(); ++k)
        for (std::size_t b = bucket_of(edges_[k].left.x); b <= bucket_of(edges_[k].right.x); ++b)
            buckets_[b].push_back(k);
}

std::size_t VerticalSections::bucket_of(double x) const {
    if (corners_.empty() || !(x > corners_.front())) return 0;
    const double share = (x - corners_.front()) / (corners_.back() - corners_.front());
    return std::min(static_cast<std::size_t>(share * static_cast<double>(buckets_.size())),
                    buckets_.size() - 1);
}

template <class Crosses>
VerticalSections::Section VerticalSections::section(double x, const Crosses& crosses) const {
    Section section;
    if (corners_.empty() || x < corners_.front() || x > corners_.back()) return section;
    for (const std::size_t k : buckets_[bucket_of(x)]) {
        const Edge& edge = edges_[k];
        if (!crosses(edge)) continue;
        const double share = (x - edge.left.x) / (edge.right.x - edge.left.x);
        const double y = edge.left.y + share * (edge.right.y - edge.left.y);
        section.top = std::max(section.top.value_or(y), y);
        section.length += edge.sign * y;
    }
    return section;
}

VerticalSections::Section VerticalSections::left_of(double x) const {
    return section(x, [x](const Edge& edge) { return edge.left.x < x && x <= edge.right.x; });
}

VerticalSections::Section VerticalSections::right_of(double x) const {
    return section(x, [x](const Edge& edge) { return edge.left.x <= x && x < edge.right.x; });
}

VerticalSections::Section VerticalSections::at(double x) const {
    const Section left = left_of(x), right = right_of(x);
    Section both{left.top, std::max(left.length, right.length)};
    if (right.top) both.top = std::max(left.top.value_or(*right.top), *right.top);
    return both;
}

}  // namespace rockslope
