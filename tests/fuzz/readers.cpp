// Feeds damaged files to the readers of slope models, block files, Shi's line files, CSV and GeoJSON. Each
// must be read or be rejected by InputError.
//   fuzz_readers SECONDS [FIRST_SEED [STEP]]        fuzz_readers --seeds FILE replays seeds, one per line
// With a step of five, first seed 0 tests slope models only, 1 block files only, and so on in the order
// above.
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "blockgen/cut/cut_blocks.hpp"
#include "blockgen/faces/enclosed_area.hpp"
#include "blockgen/input/geo_file.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "blockgen/mesh/block_file.hpp"
#include "blockgen/sampling/sample_joints.hpp"
#include "common/base/input_error.hpp"
#include "fuzz/mutator.hpp"
#include "fuzz/run_seeds.hpp"

using namespace rockslope;

namespace {

using namespace blockgen;

const char* model_text = R"(seed = 3
[domain]
outline = [[0, 0], [12, 0], [12, 8], [0, 8]]
holes = [[[1, 1], [2, 1], [2, 2]]]
block_material = "rock"
islands = "fill"
[small_blocks]
policy = "merge"
below_area = 0.1
[section]
azimuth = "90 deg"
[kinematics]
friction_angle = "30 deg"
[[region]]
name = "top"
block_material = "soil"
joint_material = "contact"
polygon = [[0, 6], [12, 6], [12, 9], [0, 9]]
[[tunnel]]
shape = "horseshoe"
floor = [6, 2]
width = 2
height = "2 m"
[[joint_set]]
name = "bedding"
angle = "-25 deg"
spacing = { law = "lognormal", mean = 2.0, sd = 0.6, min = 1.0, max = 8.0 }
[[joint_set]]
name = "cross"
kind = "cross-jointed"
ends_on = "bedding"
dip = "70 deg"
dip_direction = "80 deg"
fisher_k = 50
spacing = 2
[[joint_set]]
name = "random"
kind = "baecher"
angle = { law = "uniform", min = "0 deg", max = "90 deg" }
trace_length = { law = "gamma", mean = 3, sd = 1 }
p21 = 0.2
[[traces]]
joint_material = "fault"
points = [[0, 1], [12, 7]]
[[fixed_block]]
side = "bottom"
[[measured_point]]
name = "crest"
at = [6, 5.5]
)";

const char* geo_text =
    "0.01\n5 0\n1\n1\n1\n0\n1\n1\n0 0 6 0 1\n6 0 6 4 1\n6 4 0 4 1\n0 4 0 0 1\n-1 1 7 1 2\n0.5 0.5 5.5 0.5 7\n"
    "0.5 3.5 5.5 3.5 1e6 2e5 0\n1 0.4 5 0.4\n1 3.5\n3.5 2.5\n";

const char* csv_text = "x1,y1,x2,y2,joint_material\n0,0,3,4,\"fault\"\n# a comment\n1e0,-2.5,3,4,\n";

const char* json_text =
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"joint_material":"a"},)"
    R"("geometry":{"type":"MultiLineString","coordinates":[[[0,0],[1,2.5]],[[1,1],[2,2],[3,1e1]]]}}]})";

std::string cut_text() {
    static const std::string text = [] {
        const SlopeModel model =
            read_slope_model(ConfigTable::from_text(model_text, "slope.toml"), enclosed_area);
        return block_file_text(cut_blocks(model, all_traces(model)).mesh);
    }();
    return text;
}

const std::string& written(const std::string& text, const char* extension) {
    static std::string path;
    path = "/tmp/fuzz_readers." + std::to_string(getpid()) + extension;
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

bool passes(unsigned long seed) {
    fuzz::Mutator damage(seed);
    const std::vector<std::function<void()>> readers = {
        [&] {
            const SlopeModel model =
                read_slope_model(ConfigTable::from_text(damage.of(model_text), "slope.toml"), enclosed_area);
            CutOptions options;
            options.max_blocks = 2000;
            cut_blocks(model, all_traces(model, options.max_blocks), options);
        },
        [&] { parse_block_file(damage.of(cut_text()), "file.blocks"); },
        [&] { read_geo_file(written(damage.of(geo_text), ".geo")); },
        [&] { read_trace_file(written(damage.of(csv_text), ".csv"), "name", "joint"); },
        [&] { read_trace_file(written(damage.of(json_text), ".json"), "name", "joint"); }};
    try {
        readers[seed % readers.size()]();
    } catch (const InputError&) {
        ++fuzz::refused;
    } catch (const std::exception& error) {
        std::printf("seed %lu: %s\n", seed, error.what());
        return false;
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    const int code = fuzz::run_seeds(argc, argv, passes);
    for (const char* extension : {".geo", ".csv", ".json"}) std::remove(written("", extension).c_str());
    return code;
}
