#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

/// The orientation of a plane as the fields of a map file give it, in degrees, where they hold a number.
struct PlaneFields {
    std::optional<double> dip, dip_direction;
};

/// A line of a map file.
struct MapLine {
    std::string joint_material;  ///< from the feature's field of that name; may be empty
    std::string layer;           ///< DXF: layer of the drawing; otherwise layer of the file; may be empty
    std::vector<Point> points;
    std::vector<double> heights = {};  ///< third coordinate of each point; empty when a point has none
    PlaneFields plane = {};            ///< from the feature's fields `dip` and `dip_direction`
};

/// What a map file says of its coordinates, and what of it was not read.
struct MapNotes {
    std::string system;            ///< coordinate reference system, as PROJ understands it; empty: not stated
    std::string unit;              ///< of a drawing ($INSUNITS): "mm"; empty: not stated
    std::size_t empty = 0;         ///< geometries without a point, skipped
    std::size_t with_heights = 0;  ///< geometries with a third coordinate
};

struct MapLines {
    MapNotes notes;
    std::vector<MapLine> lines;
};

struct MapPolygons {
    MapNotes notes;
    std::vector<std::vector<Ring>> polygons;  ///< for each, the outer ring first
};

}  // namespace rockslope::blockgen
