#pragma once
#include "blockgen/picture/block_picture.hpp"
