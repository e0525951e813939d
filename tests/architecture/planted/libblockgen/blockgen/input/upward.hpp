#pragma once
#include "blockgen/arrangement/arrange.hpp"
