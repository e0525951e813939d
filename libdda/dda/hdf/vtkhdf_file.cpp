#include "dda/hdf/vtkhdf_file.hpp"

#include <algorithm>
#include <cmath>

#include "common/base/output_error.hpp"
#include "common/base/text.hpp"

namespace rockslope::dda {

namespace {

const std::string root = "/VTKHDF/";
const std::string steps = root + "Steps/";
const std::string cell_data = root + "CellData/";
const std::string cell_data_offsets = steps + "CellDataOffsets/";

/// Chunk of the small per-frame datasets, rows: 4 kB of int64.
constexpr std::size_t step_chunk = 512;
/// Space for HDF5's metadata of one frame, bytes: a few B-tree nodes and headers per dataset.
constexpr std::size_t bookkeeping = 1 << 18;

const char* const step_integers[] = {"PartOffsets", "NumberOfParts", "PointOffsets", "CellOffsets",
                                     "ConnectivityIdOffsets"};

template <class T>
std::vector<T> one(T value) {
    return {value};
}

std::size_t bytes_of(const GridFrame& frame) {
    std::size_t bytes = frame.points.size() * sizeof(double) + frame.cells.connectivity.size() * 8 +
                        frame.cells.offsets.size() * 9;
    for (const auto& column : frame.columns) bytes += column.size() * sizeof(float);
    return bytes;
}

/// Whether offsets ascend within the connectivity and the connectivity refers to existing points.
bool are_cells(const GridCells& cells, std::size_t point_count) {
    const auto is_below = [](std::int64_t value, std::size_t limit) {
        return value >= 0 && static_cast<std::size_t>(value) < limit;
    };
    return std::is_sorted(cells.offsets.begin(), cells.offsets.end()) && cells.offsets.front() >= 0 &&
           is_below(cells.offsets.back(), cells.connectivity.size() + 1) &&
           std::all_of(cells.connectivity.begin(), cells.connectivity.end(),
                       [&](std::int64_t point) { return is_below(point, point_count); });
}

}  // namespace

void GridCells::add(const std::vector<std::int64_t>& points, std::uint8_t type) {
    connectivity.insert(connectivity.end(), points.begin(), points.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    types.push_back(type);
}

VtkHdfFile::VtkHdfFile(const std::filesystem::path& path, std::vector<GridColumn> columns, HdfType points,
                       bool fixed_cells)
    : file_(HdfFile::create(path)), columns_(std::move(columns)), points_(points), fixed_cells_(fixed_cells) {
    file_.reserve(bookkeeping);
    file_.add_group("/VTKHDF");
    file_.set_attribute("/VTKHDF", "Version", std::vector<std::int64_t>{2, 0});
    file_.set_attribute("/VTKHDF", "Type", std::string("UnstructuredGrid"));
    for (const char* group : {"CellData", "PointData", "FieldData", "Steps", "Steps/CellDataOffsets"})
        file_.add_group(root + group);
    file_.add_dataset(steps + "Values", HdfType::f8, 1, step_chunk, false);
    for (const char* name : step_integers) file_.add_dataset(steps + name, HdfType::i8, 1, step_chunk, false);
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
        file_.add_dataset(root + name, HdfType::i8, 1, fixed_cells ? 1 : step_chunk, false);
}

VtkHdfFile::VtkHdfFile(const std::filesystem::path& path, std::vector<GridColumn> columns, HdfType points,
                       const GridCells& cells, std::size_t point_count)
    : VtkHdfFile(path, std::move(columns), points, true) {
    file_.reserve(bytes_of({0, {}, {}, cells}) + bookkeeping);
    file_.add_dataset(root + "Points", points, 3, point_count, true);
    file_.add_dataset(root + "Connectivity", HdfType::i8, 1, cells.connectivity.size(), true);
    file_.add_dataset(root + "Offsets", HdfType::i8, 1, cells.offsets.size(), true);
    file_.add_dataset(root + "Types", HdfType::u1, 1, cells.count(), true);
    file_.append(root + "NumberOfPoints", one(static_cast<std::int64_t>(point_count)));
    file_.append(root + "NumberOfCells", one(static_cast<std::int64_t>(cells.count())));
    file_.append(root + "NumberOfConnectivityIds", one(static_cast<std::int64_t>(cells.connectivity.size())));
    file_.append(root + "Connectivity", cells.connectivity);
    file_.append(root + "Offsets", cells.offsets);
    file_.append(root + "Types", cells.types);
    add_column_datasets(cells.count());
}

VtkHdfFile::VtkHdfFile(const std::filesystem::path& path, std::vector<GridColumn> columns, HdfType points,
                       std::size_t typical_cells)
    : VtkHdfFile(path, std::move(columns), points, false) {
    // A frame does not fill whole chunks, so the next frame rewrites the last chunk. An uncompressed chunk
    // keeps its place in the file. A compressed one would move, and a kill before the index is updated would
    // lose the frames in it.
    file_.add_dataset(root + "Points", points, 3, 2 * typical_cells, false);
    file_.add_dataset(root + "Connectivity", HdfType::i8, 1, 2 * typical_cells, false);
    file_.add_dataset(root + "Offsets", HdfType::i8, 1, typical_cells, false);
    file_.add_dataset(root + "Types", HdfType::u1, 1, typical_cells, false);
    add_column_datasets(typical_cells);
}

void VtkHdfFile::add_column_datasets(std::size_t cell_chunk) {
    for (const GridColumn& column : columns_) {
        file_.add_dataset(cell_data + column.name, HdfType::f4, column.width, cell_chunk, fixed_cells_);
        file_.add_dataset(cell_data_offsets + column.name, HdfType::i8, 1, step_chunk, false);
    }
    file_.set_attribute("/VTKHDF/Steps", "NSteps", std::int64_t{0});
    file_.flush();
}

void VtkHdfFile::check(const GridFrame& frame) const {
    const auto finite = [](const auto& values) {
        return std::all_of(values.begin(), values.end(), [](auto v) { return std::isfinite(v); });
    };
    const auto refuse = [&](const std::string& what) {
        throw OutputError(path(), what + " are not finite at t = " + shortest_text(frame.time) +
                                      " s; the frame is not written");
    };
    if (!finite(frame.points)) refuse("coordinates");
    for (std::size_t i = 0; i < columns_.size(); ++i)
        if (!finite(frame.columns[i])) refuse("values of '" + columns_[i].name + "'");
}

void VtkHdfFile::append_steps(const GridFrame& frame) {
    const std::int64_t part = fixed_cells_ ? 0 : frame_count_;
    file_.append(steps + "Values", one(frame.time));
    file_.append(steps + "PartOffsets", one(part));
    file_.append(steps + "NumberOfParts", one(std::int64_t{1}));
    file_.append(steps + "PointOffsets", one(points_before_));
    file_.append(steps + "CellOffsets", one(fixed_cells_ ? 0 : cells_before_));
    file_.append(steps + "ConnectivityIdOffsets", one(connectivity_before_));
    for (const GridColumn& column : columns_)
        file_.append(cell_data_offsets + column.name, one(cells_before_));
}

void VtkHdfFile::append(const GridFrame& frame) {
    check(frame);
    file_.reserve(bytes_of(frame) + bookkeeping);
    const auto points = static_cast<std::int64_t>(frame.points.size() / 3);
    const auto cells =
        static_cast<std::int64_t>(columns_.empty() ? 0 : frame.columns[0].size()) / columns_[0].width;
    append_steps(frame);
    if (points_ == HdfType::f4)
        file_.append(root + "Points", std::vector<float>(frame.points.begin(), frame.points.end()));
    else
        file_.append(root + "Points", frame.points);
    for (std::size_t i = 0; i < columns_.size(); ++i)
        file_.append(cell_data + columns_[i].name, frame.columns[i]);
    if (!fixed_cells_) {
        file_.append(root + "NumberOfPoints", one(points));
        file_.append(root + "NumberOfCells", one(cells));
        file_.append(root + "NumberOfConnectivityIds",
                     one(static_cast<std::int64_t>(frame.cells.connectivity.size())));
        file_.append(root + "Connectivity", frame.cells.connectivity);
        file_.append(root + "Offsets", frame.cells.offsets);
        file_.append(root + "Types", frame.cells.types);
        connectivity_before_ += static_cast<std::int64_t>(frame.cells.connectivity.size());
    }
    points_before_ += points;
    cells_before_ += cells;
    ++frame_count_;
    file_.flush();
    file_.set_attribute("/VTKHDF/Steps", "NSteps", frame_count_);
    file_.flush();
}

VtkHdfReader::VtkHdfReader(const std::filesystem::path& path) : file_(HdfFile::open_to_read(path)) {
    const auto count = static_cast<std::size_t>(file_.integer_attribute("/VTKHDF/Steps", "NSteps"));
    times_ = file_.read<double>(steps + "Values", 0, count);
    names_ = file_.names_in("/VTKHDF/CellData");
}

std::int64_t VtkHdfReader::step(const std::string& name, std::int64_t index) const {
    return file_.read<std::int64_t>(steps + name, static_cast<std::size_t>(index), 1).front();
}

GridFrame VtkHdfReader::frame(std::int64_t index, const std::vector<std::string>& columns) const {
    const auto part = static_cast<std::size_t>(step("PartOffsets", index));
    const auto count = [&](const char* name) {
        return static_cast<std::size_t>(file_.read<std::int64_t>(root + name, part, 1).front());
    };
    const auto from = [&](const std::string& name) { return static_cast<std::size_t>(step(name, index)); };
    const std::size_t cells = count("NumberOfCells");
    GridFrame frame;
    frame.time = times_[static_cast<std::size_t>(index)];
    frame.points = file_.read<double>(root + "Points", from("PointOffsets"), count("NumberOfPoints"));
    frame.cells.connectivity = file_.read<std::int64_t>(root + "Connectivity", from("ConnectivityIdOffsets"),
                                                        count("NumberOfConnectivityIds"));
    frame.cells.offsets = file_.read<std::int64_t>(root + "Offsets", from("CellOffsets") + part, cells + 1);
    frame.cells.types = file_.read<std::uint8_t>(root + "Types", from("CellOffsets"), cells);
    if (!are_cells(frame.cells, frame.points.size() / 3))
        throw OutputError(file_.path(), "the cells of frame " + std::to_string(index) + " are damaged");
    for (const std::string& name : columns)
        frame.columns.push_back(file_.read<float>(cell_data + name, from("CellDataOffsets/" + name), cells));
    return frame;
}

}  // namespace rockslope::dda
