#pragma once

#include <cstdint>
#include <vector>

#include "dda/analysis/state.hpp"

namespace rockslope::dda {

/// A State serialised for a checkpoint.
struct StateArchive {
    std::vector<double> reals;
    std::vector<std::int64_t> integers;
    std::vector<std::uint8_t> bytes;  ///< joint histories
};

StateArchive archive(const State& state);
/// The state passed to archive(), bit for bit. @throws std::runtime_error for an archive with another layout.
State restore(const StateArchive& archive);

}  // namespace rockslope::dda
