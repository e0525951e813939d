// Traces from bytes, cut with every proof: four bytes a coordinate pair, on a grid of 1/64 m, so that traces
// meet in points and run along each other.
#include <cmath>
#include <cstdlib>

#include "blockgen/cut/cut_blocks.hpp"
#include "fuzz/targets/target.hpp"

using namespace rockslope;
using namespace rockslope::blockgen;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 9) return 0;
    SlopeModel model;
    model.block_material = "rock";
    model.grid = std::ldexp(1.0, -static_cast<int>(data[0] % 21));
    model.islands = static_cast<IslandPolicy>(data[0] / 21 % 3);
    model.outline = {{0, 0}, {4, 0}, {4, 2.5}, {2, 4}, {0, 4}};
    const auto coordinate = [&](std::size_t at) { return data[at] / 64.0 + (data[at + 1] % 4) * 1e-7; };
    for (std::size_t at = 1; at + 8 <= size && model.traces.size() < 24; at += 8) {
        const Point a{coordinate(at), coordinate(at + 2)}, b{coordinate(at + 4), coordinate(at + 6)};
        model.traces.push_back({"set", "joint", {a, b}});
    }
    return fuzz::reads_or_refuses([&] {
        CutOptions options;
        options.verify = true;
        const CutResult result = cut_blocks(model, model.traces, options);
        if (!result.report.area_proved || !result.report.verified) std::abort();
    });
}
