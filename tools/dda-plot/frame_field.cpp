#include "frame_field.hpp"

#include <cmath>
#include <numbers>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"
#include "length_unit.hpp"

namespace rockslope {

namespace {

constexpr int vector_width = 3;

std::vector<std::string> names() {
    std::vector<std::string> list;
    for (const FrameField& field : frame_fields()) list.emplace_back(field.name);
    return list;
}

/// Number of components of a column of a frame.
std::size_t width_of(const std::vector<float>& column, std::size_t cells) {
    return cells == 0 ? 1 : column.size() / cells;
}

std::vector<std::optional<double>> values_of_blocks(const RunFrames& run, std::int64_t index,
                                                    const FrameField& field) {
    const dda::GridFrame frame = run.blocks(index, {field.column});
    const std::vector<float>& column = frame.columns[0];
    const std::size_t count = frame.cells.count(), width = width_of(column, count);
    const std::optional<std::size_t> base = base_cell(frame);
    std::vector<std::optional<double>> values;
    for (std::size_t b = 0; b < count; ++b) {
        if (field.component >= 0) {
            values.emplace_back(column[width * b + static_cast<std::size_t>(field.component)]);
            continue;
        }
        const double dx = column[vector_width * b] - (base ? column[vector_width * *base] : 0.0);
        const double dy = column[vector_width * b + 1] - (base ? column[vector_width * *base + 1] : 0.0);
        values.emplace_back(std::hypot(dx, dy));
    }
    return values;
}

std::vector<std::optional<double>> values_of_contacts(const RunFrames& run, std::int64_t index,
                                                      const FrameField& field) {
    const dda::GridFrame frame = run.contacts(index, {"state", field.column});
    const bool of_open = std::string(field.column) == "gap", of_all = std::string(field.column) == "slip";
    std::vector<std::optional<double>> values;
    for (std::size_t c = 0; c < frame.cells.count(); ++c) {
        const double value = frame.columns[1][c];
        const bool is_open = frame.columns[0][c] == state_open;
        if (!of_all && is_open != of_open)
            values.emplace_back(std::nullopt);
        else
            values.emplace_back(field.is_signed ? value : std::abs(value));
    }
    return values;
}

}  // namespace

const std::vector<FrameField>& frame_fields() {
    using enum FieldUnit;
    using enum FieldKind;
    static const std::vector<FrameField> fields = {
        {"displacement", "displacement", length, blocks, "displacement", -1, false},
        {"velocity", "velocity", speed, blocks, "velocity", -1, false},
        {"rotation", "rotation, counter-clockwise", angle, blocks, "rotation", 0, true},
        {"sigma_xx", "σxx, tension positive", stress, blocks, "stress", 0, true},
        {"sigma_yy", "σyy, tension positive", stress, blocks, "stress", 1, true},
        {"sigma_xy", "σxy", stress, blocks, "stress", 2, true},
        {"sigma_1", "larger principal stress, tension positive", stress, blocks, "principal_stress", 0, true},
        {"sigma_2", "smaller principal stress, tension positive", stress, blocks, "principal_stress", 1,
         true},
        {"principal_stresses", "principal stresses", stress, crosses, "stress", 0, true},
        {"material", "material", none, material, "material", 0, false},
        {"slip", "slip of joints", length, contacts, "slip", 0, false},
        {"aperture", "aperture of open joints", length, contacts, "gap", 0, false},
        {"normal_stress", "normal stress of joints", stress, contacts, "normal_stress", 0, false},
        {"shear_stress", "shear stress of joints", stress, contacts, "shear_stress", 0, false},
        {"roughness", "mobilised over peak roughness", none, contacts, "mobilised_ratio", 0, false},
    };
    return fields;
}

const FrameField& frame_field(const std::string& name) {
    for (const FrameField& field : frame_fields())
        if (name == field.name) return field;
    const auto nearest = nearest_word(name, names());
    throw InputError({"dda-plot"},
                     "--field is '" + name + "'" + (nearest ? "; did you mean '" + *nearest + "'?" : ""),
                     nearest ? "" : "one of " + frame_field_names());
}

std::string frame_field_names() {
    std::string list;
    for (const std::string& name : names()) list += (list.empty() ? "" : ", ") + name;
    return list;
}

std::vector<std::optional<double>> field_values(const RunFrames& run, std::int64_t index,
                                                const FrameField& field) {
    return field.kind == FieldKind::contacts ? values_of_contacts(run, index, field)
                                             : values_of_blocks(run, index, field);
}

ReadableUnit readable_unit(FieldUnit unit, double largest) {
    switch (unit) {
        case FieldUnit::length: {
            const LengthUnit length = readable_unit(largest);
            return {length.name, length.per_metre};
        }
        case FieldUnit::speed: {
            const LengthUnit length = readable_unit(largest);
            return {length.name + "/s", length.per_metre};
        }
        case FieldUnit::stress:
            if (largest >= 1e6) return {"MPa", 1e-6};
            return largest >= 1e3 ? ReadableUnit{"kPa", 1e-3} : ReadableUnit{"Pa", 1};
        case FieldUnit::angle:
            return {"\u00b0", 180 / std::numbers::pi};
        default:
            return {"", 1};
    }
}

}  // namespace rockslope
