#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "dda/analysis/state.hpp"

namespace rockslope::dda {

/// The numbers of a State, one after the other: what a checkpoint stores.
struct StateArchive {
    std::vector<double> reals;
    std::vector<std::int64_t> integers;
    std::vector<std::uint8_t> bytes;  ///< joint histories
};

StateArchive archive(const State& state);
/// The state that archive() was given, to the last bit. @throws std::runtime_error for an archive of another
/// shape.
State restore(const StateArchive& archive);

}  // namespace rockslope::dda
