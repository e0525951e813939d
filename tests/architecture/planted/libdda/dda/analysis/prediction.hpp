#include "dda/analysis/state.hpp"
#include "dda/analysis/step.hpp"
