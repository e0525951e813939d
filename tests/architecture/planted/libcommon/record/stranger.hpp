#pragma once
#include "dda/base/types.hpp"
