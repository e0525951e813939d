// CSMIP/CDMG V2 format: for each channel a header, then acceleration, velocity and displacement, each after a
// line such as
//   3251 points of accel data equally spaced at  .020 sec.  (units: cm/sec/sec)
// or, since about 2010,
//   7000 points of accel data equally spaced at  .010 sec, in cm/sec2. (8f10.6)
// in fields of ten characters, possibly without separators.

#include "record/fixed_fields.hpp"
#include "record/record_format.hpp"
#include "record/stacked_blocks.hpp"

namespace rockslope::record {

namespace {

constexpr FieldLayout usual_layout{8, 10};

struct CsmipAnnouncement {
    std::size_t count = 0;
    Quantity quantity = Quantity::acceleration;
    double dt = 0;     // s
    std::string unit;  // lower case
};

std::optional<CsmipAnnouncement> csmip_announcement(std::string_view line) {
    const std::string plain = lower_case(line.substr(0, 120));
    const auto words = words_of(plain, " \t():,");
    // "3251 points of accel data equally spaced at .020 sec. units cm/sec/sec"
    // "7000 points of accel data equally spaced at .010 sec in cm/sec2. 8f10.6"
    if (words.size() < 9 || words[1] != "points" || words[2] != "of" || words[5] != "equally" ||
        words[7] != "at")
        return std::nullopt;
    const auto count = field_count(words[0]);
    const auto quantity = quantity_of_abbreviation(words[3]);
    const auto dt = field_number(words[8]);
    if (!count || !quantity || !dt) return std::nullopt;
    for (std::size_t k = 9; k + 1 < words.size(); ++k)
        if (words[k] == "units" || words[k] == "in") {
            std::string_view unit = words[k + 1];
            if (unit.ends_with('.')) unit.remove_suffix(1);
            return CsmipAnnouncement{*count, *quantity, *dt, std::string(unit)};
        }
    return CsmipAnnouncement{*count, *quantity, *dt, {}};  // the model file may declare the unit
}

std::vector<StackedBlock> csmip_blocks(const RecordLines& lines) {
    std::vector<StackedBlock> blocks;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (const auto announced = csmip_announcement(lines[i])) blocks.push_back({i, announced->quantity});
    return blocks;
}

bool is_csmip(const RecordLines& lines) {
    constexpr std::size_t longest_header = 100;
    for (std::size_t i = 0; i < std::min(longest_header, lines.size()); ++i)
        if (csmip_announcement(lines[i])) return true;
    return false;
}

Record read_csmip(const RecordLines& lines, const RecordDeclaration& declaration) {
    const std::size_t line = choose_block(csmip_blocks(lines), declaration, lines).line;
    const CsmipAnnouncement announced = *csmip_announcement(lines[line]);
    check_count(announced.count, lines, line);
    check_sampling(announced.dt, announced.count, lines, line);
    const FieldLayout layout = stated_layout(lines[line]).value_or(usual_layout);
    Record record{announced.dt,
                  fixed_fields(lines, line + 1, announced.count, layout, quantity_name(announced.quantity)),
                  {}};
    expect_block_end(lines, line + 1 + layout.lines_of(announced.count), announced.count);
    resolve_units(record, announced.quantity, announced.unit, declaration, lines, line);
    return record;
}

}  // namespace

const RecordFormat csmip_format{"csmip", "CSMIP V2", true, is_csmip, read_csmip};

}  // namespace rockslope::record
