#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dda/hdf/hdf.hpp"

namespace rockslope::dda {

/// The cells of an unstructured grid: cell c has the points connectivity[offsets[c]] ...
/// connectivity[offsets[c + 1] - 1].
struct GridCells {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets = {0};
    std::vector<std::uint8_t> types;  ///< VTK's: 1 vertex, 3 line, 7 polygon

    /// Number of cells.
    std::size_t count() const { return types.size(); }
    /// Adds a cell with these points. @param type VTK's.
    void add(const std::vector<std::int64_t>& points, std::uint8_t type);
};

/// A quantity with `width` components per cell.
struct GridColumn {
    std::string name;
    int width = 1;
};

/// The names of columns, in their order.
std::vector<std::string> names_of(const std::vector<GridColumn>& columns);

/// A text about the whole file, such as the units of its columns.
struct GridText {
    std::string name;
    std::string text;
};

/// What a file holds beside the cells.
struct GridLayout {
    std::vector<GridColumn> columns;        ///< quantities per cell
    std::vector<GridColumn> point_columns;  ///< quantities per point
    std::vector<GridText> texts;
    HdfType points = HdfType::f4;  ///< type of the coordinates, f4 or f8
};

/// One frame: coordinates (x, y, z per point), the values of every column and, if they change from frame to
/// frame, the cells.
struct GridFrame {
    double time = 0;
    std::string stage = {};  ///< name of the stage that the frame belongs to
    std::vector<double> points = {};
    std::vector<std::vector<float>> columns = {};
    std::vector<std::vector<float>> point_columns = {};
    GridCells cells = {};
};

}  // namespace rockslope::dda
