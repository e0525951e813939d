// A model file of blockgen, read and cut, with at most 200 blocks.
#include "blockgen/cut/cut_blocks.hpp"
#include "blockgen/faces/enclosed_area.hpp"
#include "blockgen/sampling/sample_joints.hpp"
#include "fuzz/targets/target.hpp"

using namespace rockslope;
using namespace rockslope::blockgen;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::reads_or_refuses([&] {
        const SlopeModel model =
            read_slope_model(ConfigTable::from_text(fuzz::text_of(data, size), "slope.toml"), enclosed_area);
        CutOptions options;
        options.max_blocks = 200;
        cut_blocks(model, all_traces(model, options.max_blocks), options);
    });
}
