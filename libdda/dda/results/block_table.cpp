#include "dda/results/block_table.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include "common/base/degree.hpp"
#include "dda/writers/csv_file.hpp"

namespace rockslope::dda {

namespace {

constexpr std::size_t max_printed = 10;  // rows of the table of blocks on planes

template <class... Values>
std::string formatted(const char* format, Values... values) {
    std::array<char, 240> buffer{};
    std::snprintf(buffer.data(), buffer.size(), format, values...);
    return buffer.data();
}

Vec2 reference_displacement(const Model& model, const State& state, const Results& results) {
    if (!results.reference()) return Vec2::Zero();
    return motion_of(model, state, results.points()[*results.reference()]).displacement;
}

CsvRow& add_slip(const FirstSlip& slip, const Model& model, CsvRow& row) {
    if (!slip.has_slipped()) return row.text("").text("").text("").text("");
    return row.number(slip.time, "the time of a slip")
        .number(slip.dynamic_time, "the time of a slip")
        .integer(slip.other.value())
        .text(model.joint_material_at(slip.joint_material).name);
}

CsvRow& add_plane(const PlaneSlip* slip, CsvRow& row) {
    if (slip == nullptr) return row.text("").text("").text("").text("").text("");
    return row.integer(slip->plane.base.value())
        .number(slip->plane.dip / degree, "a dip")
        .number(slip->yield, "a yield coefficient")
        .number(slip->newmark, "an estimate of slip")
        .number(slip->simulated, "a slip");
}

/// Adds the block's area, its leftmost and rightmost corner, and its highest at the start of the run.
CsvRow& add_shape(const Model& model, const State& state, BlockIndex block, CsvRow& row) {
    row.number(state.blocks.moments[block].area, "an area");
    CornerIndex left = model.topology.block_corners[block], right = left, top = left;
    for (const CornerIndex corner : model.topology.corners_of(block)) {
        if (state.blocks.vertices[corner].x() < state.blocks.vertices[left].x()) left = corner;
        if (state.blocks.vertices[corner].x() > state.blocks.vertices[right].x()) right = corner;
        if (model.vertices[corner].y() > model.vertices[top].y()) top = corner;
    }
    for (const Vec2& place : {state.blocks.vertices[left], state.blocks.vertices[right], model.vertices[top]})
        row.number(place.x() + model.origin.x(), "a corner").number(place.y() + model.origin.y(), "a corner");
    return row;
}

const char* const headings[] = {"block",
                                "material",
                                "x (m)",
                                "y (m)",
                                "displacement x (m)",
                                "displacement y (m)",
                                "relative displacement x (m)",
                                "relative displacement y (m)",
                                "rotation (rad)",
                                "first slip (s)",
                                "first slip (s of shaking)",
                                "slipped on block",
                                "joint material",
                                "rests on block",
                                "dip (deg)",
                                "yield coefficient",
                                "Newmark slip (m)",
                                "slip (m)",
                                "area (m2)",
                                "leftmost x (m)",
                                "leftmost y (m)",
                                "rightmost x (m)",
                                "rightmost y (m)",
                                "highest x at the start (m)",
                                "highest y at the start (m)"};

std::string points_text(const Model& model, const State& state, const Results& results) {
    if (results.points().empty()) return {};
    const auto& reference = results.reference();
    const std::string from = reference ? " from '" + results.points()[*reference].name + "'" : "";
    std::string text = "point                  displaced" + from +
                       "  x (m)    y (m)   peak acceleration (m/s2)" +
                       (reference ? "         amplification\n" : "\n");
    const auto width = static_cast<int>(std::string("  x (m)").size() + from.size() + 9);
    const Vec2 reference_motion = reference_displacement(model, state, results);
    for (std::size_t k = 0; k < results.points().size(); ++k) {
        if (reference == k) continue;
        const TrackedPoint& point = results.points()[k];
        const Vec2 displacement = motion_of(model, state, point).displacement - reference_motion;
        const Peaks& peaks = results.state().peaks[k];
        text += formatted("%-22.22s %*.4f %8.4f   %24.3f", point.name.c_str(), width, displacement.x(),
                          displacement.y(), peaks.acceleration);
        const double base = reference ? results.state().peaks[*reference].smooth_acceleration : 0;
        text += base > 0 ? formatted("  %20.2f\n", peaks.smooth_acceleration / base) : "\n";
    }
    return text;
}

std::string first_slip_summary(const Results& results) {
    const std::vector<FirstSlip>& slips = results.state().first_slips;
    std::size_t count = 0, first = slips.size();
    for (std::size_t b = 0; b < slips.size(); ++b) {
        if (!slips[b].has_slipped()) continue;
        ++count;
        if (first == slips.size() || slips[b].dynamic_time < slips[first].dynamic_time) first = b;
    }
    if (count == 0) return "no block slipped\n";
    return formatted("%zu block%s slipped, block %zu first, %.3f s after shaking began\n", count,
                     count == 1 ? "" : "s", first, slips[first].dynamic_time);
}

/// One line that says what the estimates leave out; empty if they leave out nothing.
std::string ignored_text(const std::vector<PlaneSlip>& slips) {
    std::set<std::string> ignored;
    for (const PlaneSlip& slip : slips) ignored.insert(slip.ignored.begin(), slip.ignored.end());
    std::string list;
    for (const std::string& what : ignored) list += (list.empty() ? "" : ", ") + what;
    return list.empty() ? "" : "Newmark's rigid block ignores: " + list + "\n";
}

std::string planes_text(std::vector<PlaneSlip> slips) {
    if (slips.empty()) return {};
    std::stable_sort(slips.begin(), slips.end(), [](const PlaneSlip& a, const PlaneSlip& b) {
        return std::abs(a.simulated) > std::abs(b.simulated);
    });
    std::string text = "block on a plane  dip (deg)  yields at (g)  slip (m)  Newmark's rigid block (m)\n";
    for (std::size_t k = 0; k < std::min(slips.size(), max_printed); ++k)
        text += formatted("%16d  %9.2f  %13.4f  %8.4f  %25.4f\n", slips[k].plane.block,
                          slips[k].plane.dip / degree, slips[k].yield, slips[k].simulated, slips[k].newmark);
    if (slips.size() > max_printed)
        text += formatted("and %zu more in blocks.csv\n", slips.size() - max_printed);
    return text + ignored_text(slips);
}

}  // namespace

std::vector<PlaneSlip> plane_slips(const Model& model, const std::vector<Stage>& stages, const State& state,
                                   const Results& results) {
    std::vector<PlaneSlip> slips;
    for (const BlockOnPlane& plane : results.state().planes)
        if (state.is_present(plane.block))
            slips.push_back({plane, yield_coefficient(model, plane),
                             rigid_slip(model, stages, plane, state.dynamic_time),
                             simulated_slip(state, plane), ignored_by_estimate(model, plane)});
    return slips;
}

std::string block_table(const Model& model, const State& state, const Results& results,
                        const std::vector<PlaneSlip>& slips, const std::filesystem::path& path) {
    CsvRow heading(path);
    for (const char* text : headings) heading.text(text);
    std::string table = heading.line();
    const Vec2 reference_motion = reference_displacement(model, state, results);
    for (const BlockIndex block : model.blocks()) {
        if (model.motion[block] != Motion::free || !state.is_present(block)) continue;
        const Vec2 position = state.blocks.centroid(block) + model.origin;
        const Vec2 displacement = state.blocks.centroid(block) - state.centroid_origin[block];
        const std::string what = "the motion of block " + std::to_string(block.value());
        CsvRow row(path);
        row.integer(block.value()).text(model.material_of(block).name);
        for (const Vec2& v : {position, displacement, Vec2(displacement - reference_motion)})
            row.number(v.x(), what).number(v.y(), what);
        row.number(state.blocks.rotation[block], what);
        add_slip(results.state().first_slips[block], model, row);
        const auto slip = std::find_if(slips.begin(), slips.end(),
                                       [&](const PlaneSlip& s) { return s.plane.block == block; });
        add_plane(slip == slips.end() ? nullptr : &*slip, row);
        add_shape(model, state, block, row);
        table += row.line();
    }
    return table;
}

std::string outcome_table(const Model& model, const State& state, const Results& results,
                          const std::vector<PlaneSlip>& slips) {
    if (!(state.dynamic_time > 0)) return {};
    return points_text(model, state, results) + first_slip_summary(results) + planes_text(slips);
}

}  // namespace rockslope::dda
