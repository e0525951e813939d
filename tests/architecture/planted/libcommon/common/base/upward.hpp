#pragma once
#include "blockgen/mesh/block_mesh.hpp"
