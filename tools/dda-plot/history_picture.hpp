#pragma once

#include "blockgen/picture/canvas.hpp"
#include "history_table.hpp"

/// Displacement of the recorded points against time: a panel each for x and y, counted from the base where a
/// block is prescribed, and one for the base itself.
blockgen::Canvas draw_history(const HistoryTable& history);
