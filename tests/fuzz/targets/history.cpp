// history.csv of a run, as an accelerogram of one of its points.
#include "fuzz/targets/target.hpp"
#include "record/records.hpp"

using namespace rockslope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::reads_or_refuses([&] {
        record::RecordDeclaration declaration;
        declaration.format = "run";
        declaration.point = size % 2 == 0 ? "top x" : "base x";
        record::parse_record(fuzz::text_of(data, size), "history.csv", declaration);
    });
}
