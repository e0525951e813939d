#pragma once
#include "blockgen/input/slope_model.hpp"
