// A table of a laboratory test, and joints.csv of a run.
#include "dda/laboratory/shear_table.hpp"
#include "fuzz/targets/target.hpp"

using namespace rockslope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto path = fuzz::file_of(fuzz::text_of(data, size), "table.csv");
    fuzz::reads_or_refuses([&] { dda::read_shear_table(path); });
    return fuzz::reads_or_refuses([&] { dda::read_measured_joint(path, "plane"); });
}
