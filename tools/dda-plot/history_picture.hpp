#pragma once

#include "common/drawing/canvas.hpp"
#include "history_table.hpp"

namespace rockslope {

/// Displacement of the recorded points against time: a panel each for x and y, counted from the base where a
/// block is prescribed, and one for the base itself.
Canvas draw_history(const HistoryTable& history);

}  // namespace rockslope
