#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "common/geometry/vertical_sections.hpp"
#include "study/csv/csv_text.hpp"

namespace rockslope::study {

/// A block of a run at its end, less the displacement of the base.
struct EndOfBlock {
    Ring outline;
    double moved = 0;  ///< m, of its centroid relative to the base; of a block that is not free: 0
};

/// The section of a run where its displacements count from, and at its end. Blocks that were removed in
/// between are in the first alone.
struct RunOutlines {
    std::vector<Ring> start;
    std::vector<EndOfBlock> end;
};

/// Reads the outlines from the frames and the summary of a run: the last frame without displacements, and the
/// last frame. @throws InputError for a folder without frames or without a summary, and for frames that are
/// damaged.
RunOutlines read_outlines(const std::filesystem::path& results);

/// The surface of a slope at the end of a run, over that at the start, and the rock that moved. Surfaces are
/// those of all blocks, also of fixed ones. x, m, is that of the base at the start.
class Deposit {
  public:
    /// @param outlines of one run.
    explicit Deposit(const RunOutlines& outlines);

    /// y of the surface at the end, m; nothing where there is no rock.
    std::optional<double> surface(double x) const;
    /// Surface at the end less that at the start, m: positive over a deposit, negative in a scar. Nothing
    /// where one of them is missing.
    std::optional<double> height(double x) const;
    /// Vertical thickness, without gaps, of the blocks that moved farther than `limit`, m.
    double thickness(double x, double limit) const;
    /// The largest mean of the height over a stretch of this width, m: a steep face that has moved by a
    /// little is no deposit. Where there is rock at one time only, the height counts as zero. Nothing where
    /// the surface is shorter than that.
    std::optional<double> largest_height(double width) const;
    /// The largest thickness over all x.
    double largest_thickness(double limit) const;

    /// One row for each whole multiple of `interval`, m, over which there is rock: x, both surfaces, their
    /// difference, and the thickness of the blocks that moved farther than `limit`.
    TextTable profile(double interval, double limit) const;

  private:
    VerticalSections moved(double limit) const;

    std::vector<EndOfBlock> blocks_;
    VerticalSections start_, end_;
};

/// The number of stations that a profile may have.
inline constexpr double most_stations = 1e6;

}  // namespace rockslope::study
