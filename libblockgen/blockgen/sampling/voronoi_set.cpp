#include <cmath>

#include "blockgen/detail/voronoi.hpp"
#include "blockgen/sampling/rock_measure.hpp"
#include "blockgen/sampling/set_sampler.hpp"

namespace blockgen {

std::vector<Trace> sample_voronoi(SetSampler& sampler, const RockMeasure& rock) {
    // Points on a margin of ten cells bound the cells that reach into the box.
    const double cells = sampler.set().stop.target;
    const double size = std::sqrt(rock.area() / cells);
    const Bounds window = sampler.bounds().widened(10 * size);
    const double width = window.high.x - window.low.x, height = window.high.y - window.low.y;
    const auto count = static_cast<std::int64_t>(std::llround(width * height / (size * size)));
    std::vector<Point> points;
    for (std::int64_t k = 0; k < count; ++k) {
        sampler.count_draw();
        points.push_back({window.low.x + sampler.draws().draw(draw_place, k, 0) * width,
                          window.low.y + sampler.draws().draw(draw_place, k, 1) * height});
    }
    std::vector<Trace> traces;
    for (const auto& [a, b] :
         voronoi_edges(std::move(points), sampler.set().relaxation, sampler.bounds().widened(size)))
        traces.push_back(sampler.trace(a, b));
    return traces;
}

}  // namespace blockgen
