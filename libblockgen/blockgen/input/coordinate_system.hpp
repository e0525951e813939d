#pragma once

#include <span>
#include <string>

#include "common/base/input_error.hpp"
#include "common/geometry/point.hpp"

namespace rockslope::blockgen {

/// A coordinate reference system that PROJ knows, without its vertical part. Coordinates are always (east,
/// north) or (longitude, latitude), whatever order the system's authority prescribes.
class CoordinateSystem {
  public:
    CoordinateSystem() = default;
    /// @param text such as "EPSG:32634", "urn:ogc:def:crs:OGC:1.3:CRS84" or WKT. @throws InputError at
    /// `place` when PROJ does not know it.
    CoordinateSystem(const std::string& text, const SourceLocation& place);

    /// Whether this is a system; a default one is not.
    bool exists() const { return !definition_.empty(); }
    /// Whether coordinates are longitudes and latitudes.
    bool is_in_degrees() const { return is_in_degrees_; }
    /// Metres in the unit of a system that is not in degrees.
    double metres_per_unit() const { return metres_per_unit_; }
    /// Whether it has a vertical part, which says what heights are.
    bool states_heights() const { return states_heights_; }
    /// Metres in the unit of its vertical part; 1 when it has none.
    double metres_per_height_unit() const { return metres_per_height_unit_; }
    /// "EPSG:3067 (ETRS89 / TM35FIN(E,N))"
    const std::string& name() const { return name_; }
    /// "urn:ogc:def:crs:EPSG::3067", by which files name it; empty for a system without a number.
    const std::string& urn() const { return urn_; }
    /// Whether coordinates mean the same in both.
    bool is_same(const CoordinateSystem& other) const;

    /// Converts points of this system into another one. @throws InputError at `place` for a point that has no
    /// image there.
    void convert(std::span<Point> points, const CoordinateSystem& to, const SourceLocation& place) const;

  private:
    std::string definition_;  ///< WKT
    std::string name_, urn_;
    bool is_in_degrees_ = false;
    double metres_per_unit_ = 1;
    bool states_heights_ = false;
    double metres_per_height_unit_ = 1;
};

}  // namespace rockslope::blockgen
