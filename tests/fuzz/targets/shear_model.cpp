// A model file of joint-shear.
#include "dda/laboratory/read_shear_test.hpp"
#include "fuzz/targets/target.hpp"

using namespace rockslope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto path = fuzz::file_of(fuzz::text_of(data, size), "test.toml");
    return fuzz::reads_or_refuses([&] { dda::read_shear_test(path); });
}
