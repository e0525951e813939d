#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "blockgen/faces/cut_context.hpp"

namespace rockslope::blockgen {

/// The joints that a scanline crosses in the rock, between blocks as well as those that end in rock.
struct ScanlineCount {
    std::string name;
    double rock = 0;  ///< m, length of the line in the rock
    std::size_t joints = 0;
    double sound = 0;         ///< m, length of the pieces between joints or free faces that are long enough
    double sound_length = 0;  ///< m, of such a piece at least

    /// Joints per metre, 0 outside the rock.
    double frequency() const { return rock > 0 ? static_cast<double>(joints) / rock : 0; }
    /// The rock quality designation, per cent [deere1963]; 0 outside the rock.
    double rock_quality() const { return rock > 0 ? 100 * sound / rock : 0; }
    /// The rock quality designation of joints of this frequency at random places, per cent
    /// [priesthudson1976].
    double random_rock_quality() const;
};

/// Counts the joints along the scanlines of the model, in their order.
std::vector<ScanlineCount> count_along_scanlines(const CutContext& cut);

}  // namespace rockslope::blockgen
