#pragma once

#include <string>

#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// The blocks and the joints between them as a GeoJSON FeatureCollection. A block is a Polygon with the
/// properties what = "block", block (its number), block_material, area_m2 and motion ("free", "fixed" or
/// "prescribed"); a joint is a MultiLineString of its pieces between blocks with the properties what =
/// "joint", joint (its number), name and joint_material. Pieces without a joint, along outlines of regions,
/// have no number and the name "outline". A water table is a LineString across the section with what =
/// "water_table". Coordinates have all their digits.
/// @param crs the coordinate system, such as "urn:ogc:def:crs:EPSG::3067"; empty: none is stated.
std::string geojson_text(const BlockMesh& mesh, const std::string& crs);

}  // namespace rockslope::blockgen
