#include "blockgen/input/surface.hpp"

#include <algorithm>
#include <span>

#include "blockgen/input/domain.hpp"

namespace rockslope::blockgen {

namespace {

/// A chain of edges as a line over the whole domain, at its lowest height beside the chain.
HeightLine over_domain(std::vector<Point> chain, const Bounds& box) {
    if (chain.front().x > chain.back().x) std::reverse(chain.begin(), chain.end());
    if (chain.front().x > box.low.x) chain.insert(chain.begin(), {box.low, {chain.front().x, box.low.y}});
    if (chain.back().x < box.high.x)
        chain.insert(chain.end(), {{chain.back().x, box.low.y}, {box.high.x, box.low.y}});
    return chain;
}

/// Appends the longest chains of a ring along which x grows or falls. Upright edges are in none.
void append_chains(const Ring& ring, const Bounds& box, std::vector<HeightLine>& chains) {
    const auto sense = [&](std::size_t k) {
        const double step = ring[(k + 1) % ring.size()].x - ring[k % ring.size()].x;
        return int{step > 0} - int{step < 0};
    };
    std::size_t start = 0;  // an edge at which a chain begins: x turns somewhere along a ring
    while (sense(start) == sense(start + ring.size() - 1)) ++start;
    std::vector<Point> chain;
    for (std::size_t k = start; k < start + ring.size(); ++k) {
        if (chain.empty()) chain.push_back(ring[k % ring.size()]);
        chain.push_back(ring[(k + 1) % ring.size()]);
        if (k + 1 < start + ring.size() && sense(k + 1) == sense(k)) continue;
        if (sense(k) != 0) chains.push_back(over_domain(std::move(chain), box));
        chain.clear();
    }
}

/// The highest of lines at each x, by halves: n log k steps for k lines of n points.
HeightLine highest_of(std::span<const HeightLine> lines) {
    if (lines.size() == 1) return lines.front();
    const std::size_t half = lines.size() / 2;
    return upper_of(highest_of(lines.first(half)), highest_of(lines.subspan(half)));
}

}  // namespace

HeightLine ground_surface(const SlopeModel& model) {
    const Bounds box = domain_bounds(model);
    std::vector<HeightLine> chains;
    append_chains(model.outline, box, chains);
    for (const Ring& part : model.further_outlines) append_chains(part, box, chains);
    return highest_of(chains);
}

}  // namespace rockslope::blockgen
