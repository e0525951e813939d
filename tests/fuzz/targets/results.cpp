// The frames of a results file: all data of the first frame, the cells of the last.
#include "dda/hdf/library_guard.hpp"
#include "dda/hdf/vtkhdf_file.hpp"
#include "fuzz/targets/target.hpp"

using namespace rockslope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto path = fuzz::file_of(fuzz::text_of(data, size), "run.vtkhdf");
    fuzz::reads_or_refuses([&] {
        const dda::VtkHdfReader reader(path);
        if (reader.frame_count() == 0) return;
        reader.digest(1);
        reader.frame(reader.frame_count() - 1, {});
    });
    if (dda::library_has_failed()) ::_exit(0);  // it cannot be used again
    return 0;
}
