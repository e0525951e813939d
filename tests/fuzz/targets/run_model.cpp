// A model file of dda-run beside a block file and a record.
#include "dda/input/read_run.hpp"
#include "fuzz/targets/target.hpp"

using namespace rockslope;

namespace {

constexpr const char* blocks = R"(ddablk 1
counts provenance 0 block_materials 1 joint_materials 1 joints 1 vertices 8 blocks 2 rings 2 corners 10 measured_points 1 bolts 0
block_material rock
joint_material bedding
joint set
vertex 0 0
vertex 4 0
vertex 4 1
vertex 3 1
vertex 1 1
vertex 0 1
vertex 3 2
vertex 1 2
block 0 1 prescribed base
ring 0 1 2 3 4 5
edges - - - 0:0 - -
block 0 1 free
ring 4 3 6 7
edges 0:0 - - -
measured_point crest 1 2 2
end
)";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto block_file = fuzz::file_of(blocks, "two.blocks");
    static const auto record =
        fuzz::file_of("time (s),acceleration (m/s2)\n0,0\n0.1,5\n0.2,-5\n0.3,0\n", "record.csv");
    const auto path = fuzz::file_of(fuzz::text_of(data, size), "run.toml");
    return fuzz::reads_or_refuses([&] {
        dda::RunReadOptions options;
        options.blocks = block_file;
        dda::read_run(path, options);
    });
}
