#pragma once
#include "dda/plasma/field.hpp"
