#include "dda/solve/open_close_iteration.hpp"
