#include "study/table/deposit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "dda/hdf/vtkhdf_file.hpp"

namespace rockslope::study {

namespace fs = std::filesystem;

namespace {

constexpr float motion_free = 0;  ///< of the column "motion" of frames

/// The displacement at the end of the point or block that displacements are told relative to.
Point base_displacement(const fs::path& file) {
    const auto json = nlohmann::json::parse(read_text_file(file), nullptr, false);
    if (json.is_discarded() || !json.is_object())
        throw InputError({file.string()}, "is not a summary of dda-run", "summary.json as the run wrote it");
    if (!json.contains("reference")) return {};
    for (const auto& point : json.value("points", nlohmann::json::array()))
        if (point.value("name", "") == json.at("reference"))
            return {point.at("final_displacement").at(0).get<double>(),
                    point.at("final_displacement").at(1).get<double>()};
    throw InputError({file.string()}, "has no point of the name that is its reference",
                     "summary.json as the run wrote it");
}

Ring ring_of(const dda::GridFrame& frame, std::size_t cell, const Point& less) {
    Ring ring;
    for (auto k = frame.cells.offsets[cell]; k < frame.cells.offsets[cell + 1]; ++k) {
        const auto i = 3 * static_cast<std::size_t>(frame.cells.connectivity[static_cast<std::size_t>(k)]);
        ring.push_back({frame.points[i] - less.x, frame.points[i + 1] - less.y});
    }
    return ring;
}

bool is_unmoved(const dda::GridFrame& frame) {
    const auto& displacement = frame.columns.front();
    return std::all_of(displacement.begin(), displacement.end(), [](float d) { return d == 0; });
}

/// The last frame in which nothing is displaced.
dda::GridFrame start_frame(const dda::VtkHdfReader& frames) {
    for (std::int64_t k = frames.frame_count() - 1; k > 0; --k) {
        dda::GridFrame frame = frames.frame(k, {"displacement"});
        if (is_unmoved(frame)) return frame;
    }
    return frames.frame(0, {"displacement"});
}

RunOutlines outlines_of(const dda::VtkHdfReader& frames, const Point& base) {
    RunOutlines outlines;
    const dda::GridFrame start = start_frame(frames);
    for (std::size_t cell = 0; cell < start.cells.count(); ++cell)
        outlines.start.push_back(ring_of(start, cell, {}));
    const dda::GridFrame end = frames.frame(frames.frame_count() - 1, {"displacement", "motion"});
    for (std::size_t cell = 0; cell < end.cells.count(); ++cell) {
        EndOfBlock block{ring_of(end, cell, base), 0};
        const auto& displacement = end.columns[0];
        if (end.columns[1].at(cell) == motion_free)
            block.moved =
                std::hypot(displacement.at(3 * cell) - base.x, displacement.at(3 * cell + 1) - base.y);
        outlines.end.push_back(std::move(block));
    }
    return outlines;
}

std::vector<Ring> rings_of(const std::vector<EndOfBlock>& blocks) {
    std::vector<Ring> rings;
    for (const EndOfBlock& block : blocks) rings.push_back(block.outline);
    return rings;
}

std::optional<double> difference(const std::optional<double>& of, const std::optional<double>& from) {
    return of && from ? std::optional(*of - *from) : std::nullopt;
}

/// The integral of a function that is linear in pieces.
class HeightIntegral {
  public:
    /// Adds a piece to the right of those before.
    void add(double left, double right, double at_left, double at_right) {
        pieces_.push_back({left, right, at_left, at_right, sum_});
        sum_ += (right - left) * (at_left + at_right) / 2;
    }
    /// From the left end of the first piece to x.
    double at(double x) const {
        const auto next =
            std::upper_bound(pieces_.begin(), pieces_.end(), x,
                             [](double value, const Piece& piece) { return value < piece.left; });
        if (next == pieces_.begin()) return 0;
        const Piece& piece = *std::prev(next);
        const double share = std::min(1.0, (x - piece.left) / (piece.right - piece.left));
        const double height = piece.at_left + share * (piece.at_right - piece.at_left);
        return piece.before + share * (piece.right - piece.left) * (piece.at_left + height) / 2;
    }

  private:
    struct Piece {
        double left, right, at_left, at_right, before;
    };
    std::vector<Piece> pieces_;
    double sum_ = 0;
};

}  // namespace

RunOutlines read_outlines(const fs::path& results) {
    const fs::path file = dda::find_frame_files(results).blocks;
    if (file.empty())
        throw InputError({results.string()}, "contains no NAME.vtkhdf", "the output folder of dda-run");
    const Point base = base_displacement(results / "summary.json");
    try {
        const dda::VtkHdfReader frames(file);
        if (frames.frame_count() > 0) return outlines_of(frames, base);
    } catch (const OutputError& error) {
        throw InputError({file.string()}, std::string("cannot be read: ") + error.what(),
                         "the frames of dda-run");
    }
    throw InputError({file.string()}, "has no frame", "the frames of dda-run");
}

Deposit::Deposit(const RunOutlines& outlines)
    : blocks_(outlines.end), start_(outlines.start), end_(rings_of(outlines.end)) {}

VerticalSections Deposit::moved(double limit) const {
    std::vector<Ring> rings;
    for (const EndOfBlock& block : blocks_)
        if (block.moved > limit) rings.push_back(block.outline);
    return VerticalSections(rings);
}

std::optional<double> Deposit::surface(double x) const {
    return end_.at(x).top;
}

std::optional<double> Deposit::height(double x) const {
    return difference(end_.at(x).top, start_.at(x).top);
}

double Deposit::thickness(double x, double limit) const {
    return moved(limit).at(x).length;
}

std::optional<double> Deposit::largest_height(double width) const {
    HeightIntegral integral;
    std::vector<double> corners = start_.corners();
    corners.insert(corners.end(), end_.corners().begin(), end_.corners().end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        const double left = corners[k], right = corners[k + 1];
        integral.add(left, right, difference(end_.right_of(left).top, start_.right_of(left).top).value_or(0),
                     difference(end_.left_of(right).top, start_.left_of(right).top).value_or(0));
    }
    std::optional<double> largest;
    for (const double corner : corners)
        for (const double from : {corner, corner - width}) {
            if (from < corners.front() || from + width > corners.back()) continue;
            const double mean = (integral.at(from + width) - integral.at(from)) / width;
            largest = std::max(largest.value_or(mean), mean);
        }
    return largest;
}

double Deposit::largest_thickness(double limit) const {
    const VerticalSections sections = moved(limit);
    double largest = 0;
    for (const double x : sections.corners()) largest = std::max(largest, sections.at(x).length);
    return largest;
}

TextTable Deposit::profile(double interval, double limit) const {
    TextTable table;
    table.heading = {"x (m)", "surface at the start (m)", "surface (m)", "height over the start (m)",
                     "thickness of moved rock (m)"};
    const VerticalSections of_moved = moved(limit);
    double from = HUGE_VAL, to = -HUGE_VAL;
    for (const VerticalSections* sections : {&start_, &end_})
        if (!sections->corners().empty()) {
            from = std::min(from, sections->corners().front());
            to = std::max(to, sections->corners().back());
        }
    if (!(to >= from)) return table;
    if ((to - from) / interval > most_stations)
        throw InputError({"the profile"},
                         "has more than a million stations over " + shortest_text(to - from) + " m",
                         "a longer interval than " + shortest_text(interval) + " m");
    // 3 / 10 in place of 3 * 0.1, which is 0.30000000000000004.
    const double in_one = std::round(1 / interval);
    const auto station = [&](double k) {
        return std::abs(in_one * interval - 1) < 1e-12 ? k / in_one : k * interval;
    };
    for (double k = std::ceil(from / interval); station(k) <= to; ++k) {
        const double x = station(k);
        const auto before = start_.at(x).top, after = end_.at(x).top;
        table.rows.push_back({shortest_text(x), number_field(before), number_field(after),
                              number_field(difference(after, before)), shortest_text(of_moved.at(x).length)});
    }
    return table;
}

}  // namespace rockslope::study
