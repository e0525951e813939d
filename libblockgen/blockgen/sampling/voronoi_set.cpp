#include <cmath>

#include "blockgen/arrangement/voronoi.hpp"
#include "blockgen/sampling/rock_domain.hpp"
#include "blockgen/sampling/set_sampler.hpp"

namespace rockslope::blockgen {

namespace {

/// Side of a square with the mean area of a cell, m.
double cell_size(const SetSampler& sampler, double rock_area) {
    return std::sqrt(rock_area / sampler.set().stop.target);
}

}  // namespace

Bounds voronoi_window(const SetSampler& sampler, double rock_area) {
    return sampler.bounds().expanded(10 * cell_size(sampler, rock_area));
}

std::vector<Trace> sample_voronoi(SetSampler& sampler, const RockDomain& rock) {
    const double size = cell_size(sampler, rock.area());
    const Bounds window = voronoi_window(sampler, rock.area());
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
         voronoi_edges(std::move(points), sampler.set().relaxation, sampler.bounds().expanded(size)))
        traces.push_back(sampler.trace(std::nullopt, a, b));
    return traces;
}

}  // namespace rockslope::blockgen
