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
const std::string point_data = root + "PointData/";
const std::string point_data_offsets = steps + "PointDataOffsets/";
const std::string field_data = root + "FieldData/";
const std::string field_data_offsets = steps + "FieldDataOffsets/";

/// Chunk of the small per-frame datasets, rows: 4 kB of int64.
constexpr std::size_t step_chunk = 512;
/// Points in a chunk for each cell: the two ends of a contact.
constexpr std::size_t points_per_cell = 2;
/// Parts of a chunk of cells: the frame's, and one of the cells that fill it up.
constexpr std::size_t parts_per_chunk = 2;
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
    for (const auto& column : frame.point_columns) bytes += column.size() * sizeof(float);
    return bytes;
}

template <class T>
bool are_finite(const std::vector<T>& values) {
    return std::all_of(values.begin(), values.end(), [](T value) { return std::isfinite(value); });
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

std::vector<std::string> names_of(const std::vector<GridColumn>& columns) {
    std::vector<std::string> names;
    for (const GridColumn& column : columns) names.push_back(column.name);
    return names;
}

void GridCells::add(const std::vector<std::int64_t>& points, std::uint8_t type) {
    connectivity.insert(connectivity.end(), points.begin(), points.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    types.push_back(type);
}

VtkHdfFile::VtkHdfFile(const std::filesystem::path& path, GridLayout layout, std::size_t cell_chunk,
                       bool fixed_cells)
    : file_(HdfFile::create(path)),
      layout_(std::move(layout)),
      cell_chunk_(cell_chunk),
      fixed_cells_(fixed_cells) {
    file_.reserve(bookkeeping);
    file_.add_group("/VTKHDF");
    file_.set_attribute("/VTKHDF", "Version", std::vector<std::int64_t>{2, 0});
    file_.set_attribute("/VTKHDF", "Type", std::string("UnstructuredGrid"));
    for (const char* group : {"CellData", "PointData", "FieldData", "Steps", "Steps/CellDataOffsets",
                              "Steps/PointDataOffsets", "Steps/FieldDataOffsets"})
        file_.add_group(root + group);
    file_.add_dataset(steps + "Values", HdfType::f8, 1, step_chunk, false);
    for (const char* name : step_integers) file_.add_dataset(steps + name, HdfType::i8, 1, step_chunk, false);
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
        file_.add_dataset(root + name, HdfType::i8, 1, fixed_cells ? 1 : step_chunk, false);
    add_text_datasets();
}

VtkHdfFile::VtkHdfFile(const std::filesystem::path& path, GridLayout layout, const GridCells& cells,
                       std::size_t point_count)
    : VtkHdfFile(path, std::move(layout), cells.count(), true) {
    cells_ = FrameDigest::of_cells(cells);
    file_.reserve(bytes_of({.cells = cells}) + bookkeeping);
    file_.add_dataset(root + "Points", layout_.points, 3, point_count, true);
    file_.add_dataset(root + "Connectivity", HdfType::i8, 1, cells.connectivity.size(), true);
    file_.add_dataset(root + "Offsets", HdfType::i8, 1, cells.offsets.size(), true);
    file_.add_dataset(root + "Types", HdfType::u1, 1, cells.count(), true);
    file_.append(root + "NumberOfPoints", one(static_cast<std::int64_t>(point_count)));
    file_.append(root + "NumberOfCells", one(static_cast<std::int64_t>(cells.count())));
    file_.append(root + "NumberOfConnectivityIds", one(static_cast<std::int64_t>(cells.connectivity.size())));
    file_.append(root + "Connectivity", cells.connectivity);
    file_.append(root + "Offsets", cells.offsets);
    file_.append(root + "Types", cells.types);
    add_column_datasets(cells.count(), point_count);
}

VtkHdfFile::VtkHdfFile(const std::filesystem::path& path, GridLayout layout, std::size_t typical_cells)
    : VtkHdfFile(path, std::move(layout), std::max<std::size_t>(typical_cells, 1), false) {
    file_.add_dataset(root + "Points", layout_.points, 3, points_per_cell * cell_chunk_, true);
    file_.add_dataset(root + "Connectivity", HdfType::i8, 1, points_per_cell * cell_chunk_, true);
    file_.add_dataset(root + "Offsets", HdfType::i8, 1, cell_chunk_ + parts_per_chunk, true);
    file_.add_dataset(root + "Types", HdfType::u1, 1, cell_chunk_, true);
    add_column_datasets(cell_chunk_, points_per_cell * cell_chunk_);
}

void VtkHdfFile::add_text_datasets() {
    for (const GridText& text : layout_.texts) {
        file_.add_text_dataset(field_data + text.name);
        file_.append_text(field_data + text.name, text.text);
        file_.add_dataset(field_data_offsets + text.name, HdfType::i8, 1, step_chunk, false);
    }
    file_.add_text_dataset(field_data + "stage");
    file_.add_dataset(field_data_offsets + "stage", HdfType::i8, 1, step_chunk, false);
}

void VtkHdfFile::add_column_datasets(std::size_t cell_chunk, std::size_t point_chunk) {
    for (const GridColumn& column : layout_.columns) {
        file_.add_dataset(cell_data + column.name, HdfType::f4, column.width, cell_chunk, true);
        file_.add_dataset(cell_data_offsets + column.name, HdfType::i8, 1, step_chunk, false);
    }
    for (const GridColumn& column : layout_.point_columns) {
        file_.add_dataset(point_data + column.name, HdfType::f4, column.width, point_chunk, true);
        file_.add_dataset(point_data_offsets + column.name, HdfType::i8, 1, step_chunk, false);
    }
    file_.set_attribute("/VTKHDF/Steps", "NSteps", std::int64_t{0});
    file_.flush();
}

void VtkHdfFile::check(const GridFrame& frame) const {
    const auto refuse = [&](const std::string& what) {
        throw OutputError(path(), what + " are not finite at t = " + shortest_text(frame.time) +
                                      " s; the frame is not written");
    };
    const bool fit = layout_.points == HdfType::f8 ||
                     std::all_of(frame.points.begin(), frame.points.end(),
                                 [](double v) { return std::isfinite(static_cast<float>(v)); });
    if (!fit || !are_finite(frame.points)) refuse("coordinates");
    for (std::size_t i = 0; i < layout_.columns.size(); ++i)
        if (!are_finite(frame.columns[i])) refuse("values of '" + layout_.columns[i].name + "'");
    for (std::size_t i = 0; i < layout_.point_columns.size(); ++i)
        if (!are_finite(frame.point_columns[i]))
            refuse("values of '" + layout_.point_columns[i].name + "' at points");
}

/// A frame with its own cells takes whole chunks, filled up with zeros: a compressed chunk that is written
/// again would move in the file, and a kill before the index is updated would lose the frames in it. The
/// zeros are cells without points, in a part of their own behind the frame's. A reader expects the offsets of
/// a part at its first cell plus its number, so that a frame of several chunks takes two parts for each.
VtkHdfFile::Rows VtkHdfFile::rows_of(const GridFrame& frame) const {
    const std::size_t points = frame.points.size() / 3;
    if (fixed_cells_) return {points, frame.columns[0].size() / layout_.columns[0].width, 0, 0};
    const auto chunks_for = [](std::size_t rows, std::size_t chunk) { return (rows + chunk - 1) / chunk; };
    const std::size_t wide = points_per_cell * cell_chunk_;
    const std::size_t chunks =
        std::max({std::size_t{1}, chunks_for(frame.cells.count(), cell_chunk_), chunks_for(points, wide),
                  chunks_for(frame.cells.connectivity.size(), wide)});
    return {chunks * wide, chunks * cell_chunk_, chunks * wide, parts_per_chunk * chunks};
}

/// Appends values and zeros up to `count` of them.
template <class T>
void VtkHdfFile::append_padded(const std::string& name, std::vector<T> values, std::size_t count) {
    values.resize(count);
    file_.append(name, values);
}

void VtkHdfFile::append_steps(const GridFrame& frame) {
    const auto row = [](std::size_t value) { return one(static_cast<std::int64_t>(value)); };
    file_.append(steps + "Values", one(frame.time));
    file_.append(steps + "PartOffsets", row(before_.parts));
    file_.append(steps + "NumberOfParts", one(std::int64_t{1}));
    file_.append(steps + "PointOffsets", row(before_.points));
    file_.append(steps + "CellOffsets", row(fixed_cells_ ? 0 : before_.cells));
    file_.append(steps + "ConnectivityIdOffsets", row(before_.connectivity));
    for (const GridColumn& column : layout_.columns)
        file_.append(cell_data_offsets + column.name, row(before_.cells));
    for (const GridColumn& column : layout_.point_columns)
        file_.append(point_data_offsets + column.name, row(before_.points));
    for (const GridText& text : layout_.texts) file_.append(field_data_offsets + text.name, row(0));
    if (stages_.empty() || stages_.back() != frame.stage) {
        stages_.push_back(frame.stage);
        file_.append_text(field_data + "stage", frame.stage);
    }
    file_.append(field_data_offsets + "stage", row(stages_.size() - 1));
}

void VtkHdfFile::append_cells(const GridFrame& frame, const Rows& rows) {
    const auto append_counts = [&](const char* name, std::size_t used, std::size_t taken) {
        const std::vector<std::int64_t> counts = {static_cast<std::int64_t>(used),
                                                  static_cast<std::int64_t>(taken - used)};
        append_padded(root + name, counts, rows.parts);
    };
    append_counts("NumberOfPoints", frame.points.size() / 3, rows.points);
    append_counts("NumberOfCells", frame.cells.count(), rows.cells);
    append_counts("NumberOfConnectivityIds", frame.cells.connectivity.size(), rows.connectivity);
    append_padded(root + "Connectivity", frame.cells.connectivity, rows.connectivity);
    append_padded(root + "Offsets", frame.cells.offsets, rows.cells + rows.parts);
    append_padded(root + "Types", frame.cells.types, rows.cells);
}

void VtkHdfFile::append(const GridFrame& frame) {
    check(frame);
    file_.reserve(bytes_of(frame) + bookkeeping);
    const Rows rows = rows_of(frame);
    append_steps(frame);
    if (layout_.points == HdfType::f4)
        append_padded(root + "Points", std::vector<float>(frame.points.begin(), frame.points.end()),
                      3 * rows.points);
    else
        append_padded(root + "Points", frame.points, 3 * rows.points);
    for (std::size_t i = 0; i < layout_.columns.size(); ++i)
        append_padded(cell_data + layout_.columns[i].name, frame.columns[i],
                      rows.cells * layout_.columns[i].width);
    for (std::size_t i = 0; i < layout_.point_columns.size(); ++i)
        append_padded(point_data + layout_.point_columns[i].name, frame.point_columns[i],
                      rows.points * layout_.point_columns[i].width);
    if (!fixed_cells_) append_cells(frame, rows);
    add_to_digest(frame);
    before_.points += rows.points;
    before_.cells += rows.cells;
    before_.connectivity += rows.connectivity;
    before_.parts += rows.parts;
    ++frame_count_;
    file_.flush();
    file_.set_attribute("/VTKHDF/Steps", "NSteps", frame_count_);
    file_.flush();
}

/// Adds a frame as it will be read, with coordinates of the file's precision.
void VtkHdfFile::add_to_digest(const GridFrame& frame) {
    GridFrame stored = frame;
    if (layout_.points == HdfType::f4)
        for (double& coordinate : stored.points) coordinate = static_cast<float>(coordinate);
    digest_.add(stored, names_of(layout_.columns), names_of(layout_.point_columns),
                fixed_cells_ ? cells_ : FrameDigest::of_cells(frame.cells));
}

VtkHdfReader::VtkHdfReader(const std::filesystem::path& path) : file_(HdfFile::open_to_read(path)) {
    const auto count = static_cast<std::size_t>(file_.integer_attribute("/VTKHDF/Steps", "NSteps"));
    times_ = file_.read<double>(steps + "Values", 0, count);
    if (!are_finite(times_)) throw OutputError(file_.path(), "the times of its frames are damaged");
    names_ = file_.names_in("/VTKHDF/CellData");
    stages_.resize(count);
    if (file_.has(field_data + "stage")) read_stages();
}

void VtkHdfReader::read_stages() {
    const std::vector<std::string> names = file_.read_texts(field_data + "stage");
    const auto numbers = file_.read<std::int64_t>(field_data_offsets + "stage", 0, times_.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const auto number = static_cast<std::size_t>(numbers[k]);
        if (number >= names.size())
            throw OutputError(file_.path(), "the stage of frame " + std::to_string(k) + " is damaged");
        stages_[k] = names[number];
    }
}

std::string VtkHdfReader::digest(std::int64_t frames) const {
    const std::vector<std::string> point_names = file_.names_in("/VTKHDF/PointData");
    FrameDigest digest;
    for (std::int64_t k = 0; k < frames; ++k) {
        const GridFrame read = frame(k, names_, point_names);
        digest.add(read, names_, point_names, FrameDigest::of_cells(read.cells));
    }
    return digest.digest();
}

bool VtkHdfReader::has_point_column(const std::string& name) const {
    return file_.has(point_data + name);
}

std::string VtkHdfReader::text(const std::string& name) const {
    if (!file_.has(field_data + name)) return {};
    const std::vector<std::string> texts = file_.read_texts(field_data + name);
    return texts.empty() ? std::string{} : texts.front();
}

std::int64_t VtkHdfReader::step(const std::string& name, std::int64_t index) const {
    return file_.read<std::int64_t>(steps + name, static_cast<std::size_t>(index), 1).front();
}

GridFrame VtkHdfReader::frame(std::int64_t index, const std::vector<std::string>& columns,
                              const std::vector<std::string>& point_columns) const {
    const auto part = static_cast<std::size_t>(step("PartOffsets", index));
    const auto count = [&](const char* name) {
        return static_cast<std::size_t>(file_.read<std::int64_t>(root + name, part, 1).front());
    };
    const auto from = [&](const std::string& name) { return static_cast<std::size_t>(step(name, index)); };
    const std::size_t cells = count("NumberOfCells");
    GridFrame frame;
    frame.time = times_[static_cast<std::size_t>(index)];
    frame.stage = stages_[static_cast<std::size_t>(index)];
    frame.points = file_.read<double>(root + "Points", from("PointOffsets"), count("NumberOfPoints"));
    frame.cells.connectivity = file_.read<std::int64_t>(root + "Connectivity", from("ConnectivityIdOffsets"),
                                                        count("NumberOfConnectivityIds"));
    frame.cells.offsets = file_.read<std::int64_t>(root + "Offsets", from("CellOffsets") + part, cells + 1);
    frame.cells.types = file_.read<std::uint8_t>(root + "Types", from("CellOffsets"), cells);
    if (!are_cells(frame.cells, frame.points.size() / 3))
        throw OutputError(file_.path(), "the cells of frame " + std::to_string(index) + " are damaged");
    for (const std::string& name : columns)
        frame.columns.push_back(file_.read<float>(cell_data + name, from("CellDataOffsets/" + name), cells));
    for (const std::string& name : point_columns)
        frame.point_columns.push_back(
            file_.read<float>(point_data + name, from("PointDataOffsets/" + name), count("NumberOfPoints")));
    const auto are_finite_columns = [](const std::vector<std::vector<float>>& read) {
        return std::all_of(read.begin(), read.end(), are_finite<float>);
    };
    if (!are_finite(frame.points) || !are_finite_columns(frame.columns) ||
        !are_finite_columns(frame.point_columns))
        throw OutputError(file_.path(), "numbers of frame " + std::to_string(index) + " are damaged");
    return frame;
}

FrameFiles find_frame_files(const std::filesystem::path& folder) {
    const std::string of_contacts = ".joints.vtkhdf", extension = ".vtkhdf";
    FrameFiles files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string file = entry.path().filename().string();
        if (!file.ends_with(extension) || file.ends_with(of_contacts)) continue;
        files.name = file.substr(0, file.size() - extension.size());
        files.blocks = entry.path();
    }
    const std::filesystem::path contacts = folder / (files.name + of_contacts);
    if (!files.name.empty() && std::filesystem::exists(contacts)) files.contacts = contacts;
    return files;
}

}  // namespace rockslope::dda
