// A block file: read, checked for bad rings and overlaps, and written again to the same mesh.
#include <cstdlib>

#include "blockgen/mesh/block_file.hpp"
#include "blockgen/mesh/check_mesh.hpp"
#include "blockgen/mesh/find_overlap.hpp"
#include "fuzz/targets/target.hpp"

using namespace rockslope;
using namespace rockslope::blockgen;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::reads_or_refuses([&] {
        const BlockMesh mesh = parse_block_file(fuzz::text_of(data, size), "file.blocks");
        if (!(parse_block_file(block_file_text(mesh), "again.blocks") == mesh)) std::abort();
        check_mesh(mesh, "file.blocks");
        find_overlap(mesh);
    });
}
