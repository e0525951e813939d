// An accelerogram in any format that is recognised by content.
#include <cmath>
#include <cstdlib>

#include "fuzz/targets/target.hpp"
#include "record/records.hpp"

using namespace rockslope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::reads_or_refuses([&] {
        const record::Record record = record::parse_record(fuzz::text_of(data, size), "record");
        if (!(record.dt > 0) || record.values.size() < 2) std::abort();
        for (const double value : record.values)
            if (!std::isfinite(value)) std::abort();
    });
}
