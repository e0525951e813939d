#pragma once
#include <CGAL/Arrangement_2.h>
#include <suitesparse/cholmod.h>

#include "blockgen/mesh/block_mesh.hpp"
