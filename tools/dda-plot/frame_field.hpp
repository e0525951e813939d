#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run_frames.hpp"

namespace rockslope {

/// The unit of a field.
enum class FieldUnit { length, speed, stress, angle, none };

/// How a field is drawn.
enum class FieldKind {
    blocks,    ///< each block has the colour of its value
    material,  ///< each block has the colour of its material
    crosses,   ///< principal stresses as crosses of two lines
    contacts   ///< each contact has the colour of its value, on pale blocks
};

/// A quantity that the picture of a frame can show.
struct FrameField {
    const char* name;   ///< as --field names it
    const char* title;  ///< of the colour bar, without its unit
    FieldUnit unit;
    FieldKind kind;
    const char* column;  ///< of the frames; empty: none is read
    int component;       ///< of the column; -1: the length of a vector, less that of the base
    bool is_signed;      ///< the colours go both ways from zero
};

/// All fields. To add one, add a line.
const std::vector<FrameField>& frame_fields();

/// The field of a name. @throws InputError with the nearest name.
const FrameField& frame_field(const std::string& name);

/// The names of all fields, separated by commas.
std::string frame_field_names();

/// The values of a field, one for each block or contact of a frame, SI units. Displacements and velocities
/// are relative to the base. Open contacts have no stress and no roughness, closed ones no aperture: nothing
/// then.
std::vector<std::optional<double>> field_values(const RunFrames& run, std::int64_t index,
                                                const FrameField& field);

/// A unit that suits values up to `largest`: its name and its factor from SI.
struct ReadableUnit {
    std::string name;
    double factor;
};
ReadableUnit readable_unit(FieldUnit unit, double largest);

}  // namespace rockslope
