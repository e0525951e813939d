#pragma once
#include "dda/joint/joint_law.hpp"
