#include "run_frames.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "common/base/input_error.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope {

namespace {

/// The names in lines of "NUMBER NAME", by their numbers.
std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t space = line.find(' ');
        if (space != std::string::npos) names.push_back(line.substr(space + 1));
    }
    return names;
}

}  // namespace

RunFrames::RunFrames(const std::filesystem::path& folder) {
    const dda::FrameFiles files = dda::find_frame_files(folder);
    if (files.name.empty())
        throw InputError({folder.string()}, "contains no NAME.vtkhdf", "the output folder of dda-run");
    name_ = files.name;
    blocks_.emplace(files.blocks);
    times_ = blocks_->times();
    if (files.contacts.empty()) return;
    contacts_.emplace(files.contacts);
    times_.resize(std::min(times_.size(), contacts_->times().size()));
}

dda::GridFrame RunFrames::blocks(std::int64_t index, std::vector<std::string> columns,
                                 const std::vector<std::string>& point_columns) const {
    columns.emplace_back("motion");
    dda::GridFrame frame = blocks_->frame(index, columns, point_columns);
    const std::size_t count = frame.cells.count();
    const bool whole = std::all_of(frame.columns.begin(), frame.columns.end(), [&](const auto& column) {
        return column.size() >= count && (count == 0 || column.size() % count == 0);
    });
    if (!whole || frame.columns.back().size() != count)
        throw InputError({name_ + ".vtkhdf"}, "is damaged", "the frames of dda-run");
    return frame;
}

dda::GridFrame RunFrames::contacts(std::int64_t index, const std::vector<std::string>& columns) const {
    if (contacts_) return contacts_->frame(index, columns);
    dda::GridFrame none;
    none.columns.resize(columns.size());
    return none;
}

bool RunFrames::has_point_displacements() const {
    return blocks_->has_point_column("displacement");
}

std::string RunFrames::title(std::int64_t index) const {
    const auto k = static_cast<std::size_t>(index);
    const std::string& name = stage(index);
    char text[48];
    if (name.empty()) {
        std::snprintf(text, sizeof text, "t = %.3f s", times_[k]);
        return text;
    }
    std::size_t first = k;
    while (first > 0 && blocks_->stages()[first - 1] == name) --first;
    std::snprintf(text, sizeof text, ", %.3f s", times_[k] - times_[first]);
    return name + text;
}

std::vector<std::string> RunFrames::block_materials() const {
    return names_in(blocks_->text("block_materials"));
}

std::vector<std::string> RunFrames::joint_materials() const {
    return contacts_ ? names_in(contacts_->text("joint_materials")) : std::vector<std::string>{};
}

const std::string& RunFrames::stage(std::int64_t index) const {
    return blocks_->stages()[static_cast<std::size_t>(index)];
}

std::vector<std::string> RunFrames::joints() const {
    return contacts_ ? names_in(contacts_->text("joints")) : std::vector<std::string>{};
}

std::vector<Point> cell_points(const dda::GridFrame& frame, std::size_t cell) {
    std::vector<Point> points;
    for (auto k = frame.cells.offsets[cell]; k < frame.cells.offsets[cell + 1]; ++k) {
        const auto i = 3 * static_cast<std::size_t>(frame.cells.connectivity[static_cast<std::size_t>(k)]);
        points.push_back({frame.points[i], frame.points[i + 1]});
    }
    return points;
}

double cell_area(const dda::GridFrame& frame, std::size_t cell) {
    return twice_signed_area(cell_points(frame, cell)) / 2;
}

std::optional<std::size_t> base_cell(const dda::GridFrame& frame) {
    const auto& motion = frame.columns.back();
    const auto base = std::find(motion.begin(), motion.end(), motion_prescribed);
    if (base == motion.end()) return std::nullopt;
    return static_cast<std::size_t>(base - motion.begin());
}

}  // namespace rockslope
