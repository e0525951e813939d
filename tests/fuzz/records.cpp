// Feeds damaged ground-motion records in every format to their readers, with the format recognised by
// content or declared, sometimes wrongly. Each must give a valid record or be rejected by InputError.
//   fuzz_records SECONDS [FIRST_SEED [STEP]]        fuzz_records --seeds FILE replays seeds, one per line
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "common/base/input_error.hpp"
#include "fuzz/mutator.hpp"
#include "fuzz/run_seeds.hpp"
#include "record/records.hpp"
#include "unit/record/small_records.hpp"

using namespace rockslope;

namespace {

/// A miniSEED file: a header that is recognised, and samples that are not read.
std::string miniseed() {
    std::string text = "000001D ABCD 00HNEXX";
    return text + std::string(512 - text.size(), '\0');
}

std::string run_history() {
    std::string text = "time (s),stage,top ux (m),top ax (m/s2),prescribed base ax (m/s2)\n0,settle,0,0,0\n";
    for (int k = 0; k < 10; ++k) text += "0." + std::to_string(k) + ",shake,1e-3,-2.5,\"4\"\n";
    return text;
}

std::vector<small_records::SmallRecord> undamaged_records() {
    std::vector<small_records::SmallRecord> records = small_records::all();
    records.push_back({"miniseed", miniseed()});
    records.push_back({"run", run_history()});
    return records;
}

/// A declaration that mostly fits the file, so that the damage decides; sometimes with another format or
/// unit.
record::RecordDeclaration declaration_of(fuzz::Mutator& damage, const std::string& format) {
    static const std::vector<std::string> keys = record::record_format_keys();
    static const std::vector<std::string> units = {"g", "cm/s2", "m/s", "mm"};
    record::RecordDeclaration declaration;
    if (format == "sac") declaration = {record::Quantity::acceleration, "m/s2", ""};
    if (format == "run") declaration.point = damage.pick(2) == 0 ? "top x" : "base x";
    if (damage.pick(3) == 0) declaration.format = format;
    if (damage.pick(20) == 0) declaration.format = keys[damage.pick(keys.size())];
    if (damage.pick(20) == 0) declaration.quantity = static_cast<record::Quantity>(damage.pick(3));
    if (damage.pick(20) == 0) declaration.unit = units[damage.pick(units.size())];
    if (damage.pick(20) == 0) declaration.channel = 1 + static_cast<int>(damage.pick(3));
    return declaration;
}

bool is_valid(const record::Record& record) {
    if (!(record.dt > 0) || record.values.size() < 2) return false;
    for (const double value : record.values)
        if (!std::isfinite(value)) return false;
    return true;
}

bool passes(unsigned long seed) {
    static const std::vector<small_records::SmallRecord> records = undamaged_records();
    fuzz::Mutator damage(seed);
    const small_records::SmallRecord& start = records[seed % records.size()];
    const record::RecordDeclaration declaration = declaration_of(damage, start.format);
    try {
        const record::Record record = record::parse_record(damage.of(start.text), "record", declaration);
        if (is_valid(record)) return true;
        std::printf("seed %lu (%s): %zu samples at %g s, or a sample that is not finite\n", seed,
                    start.format, record.values.size(), record.dt);
        return false;
    } catch (const InputError&) {
        ++fuzz::refused;
        return true;
    } catch (const std::exception& error) {
        std::printf("seed %lu (%s): %s\n", seed, start.format, error.what());
        return false;
    }
}

}  // namespace

int main(int argc, char** argv) {
    return fuzz::run_seeds(argc, argv, passes);
}
