#pragma once
#include "blockgen/picture/canvas.hpp"
