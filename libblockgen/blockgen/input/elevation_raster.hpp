#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

/// A digital elevation model in any raster format of GDAL: one band of elevations at the centres of its
/// cells.
class ElevationRaster {
  public:
    /// @throws InputError for a file that is no raster of one band, or has no place on the map.
    explicit ElevationRaster(const std::filesystem::path& path);

    /// The corners of the raster's outer cells, in its coordinates.
    Ring corners() const;
    /// The coordinate reference system, as PROJ understands it; empty when the file states none.
    const std::string& system() const { return system_; }
    /// The unit of the elevations, in the file's words; empty when it states none.
    const std::string& unit() const { return unit_; }

    /// Column and row of a point, counted in cells from the centre of the first one.
    Point cell_of(const Point& p) const;
    /// Whether a point lies in a cell of the raster.
    bool contains(const Point& p) const;
    /// The elevation at a point that lies in the raster, in the file's unit: bilinear between the centres of
    /// the four cells round it, so exact for a plane, with an error of at most (h_u^2 |z_uu| + h_v^2 |z_vv|)
    /// / 8 for cells of h_u by h_v. In the outer half of the outer cells the surface of the nearest four is
    /// prolonged. Nothing when one of the four that count has no elevation.
    /// @throws InputError when the file is damaged there.
    std::optional<double> elevation_at(const Point& p) const;

  private:
    std::string path_, system_, unit_;
    std::shared_ptr<void> dataset_;
    void* band_ = nullptr;
    void* mask_ = nullptr;  ///< which cells have an elevation
    double place_[6] = {};  ///< GDAL's affine map from cells to coordinates
    int columns_ = 0, rows_ = 0;
    double scale_ = 1, offset_ = 0;  ///< elevation = scale x stored value + offset
};

}  // namespace rockslope::blockgen
