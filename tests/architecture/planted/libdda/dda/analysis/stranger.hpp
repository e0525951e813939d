#include "dda/analysis/step.hpp"
