// A checkpoint whose digest is right, so that its bytes reach HDF5 and what restores a state.
#include "dda/checkpoint/checkpoint.hpp"
#include "common/base/sha256.hpp"
#include "dda/hdf/library_guard.hpp"
#include "fuzz/targets/target.hpp"

using namespace rockslope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(fuzz::text_of(data, size));
    const auto path = fuzz::file_of(bytes + "\nsha256 " + sha256(bytes), "checkpoint.h5");
    fuzz::reads_or_refuses([&] { dda::read_checkpoint(path); });
    if (dda::library_has_failed()) ::_exit(0);  // it cannot be used again
    return 0;
}
