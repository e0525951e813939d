#pragma once

#include <vector>

#include "report_bytes.hpp"
#include "run_frames.hpp"

namespace rockslope {

/// A block as it was where displacements count from: its corners, and where its centroid was.
struct ReportBlock {
    int number = 0;
    int material = 0;
    bool moves = false;  ///< neither fixed nor prescribed
    std::vector<Point> corners;
    Point centroid;
};

/// Two blocks in contact, and where: a line in coordinates of the first block from its centroid.
struct ReportPair {
    std::size_t block = 0, other = 0;  ///< indices of blocks
    int joint_material = 0;
    int joint = -1;
    Point from, to;
};

/// The state of a pair of blocks in a frame.
enum class PairState : std::uint8_t { apart, open, sliding, locked };

/// What the blocks of a run do, frame by frame, relative to the base.
struct ReportMotion {
    std::vector<std::int64_t> frames;  ///< of the run
    std::vector<ReportBlock> blocks;
    std::vector<ReportPair> pairs;
    std::vector<Point> base;  ///< m, displacement of the base in each frame
    /// Displacement (m) of the blocks' centroids, rotation (rad), and smaller principal stress (Pa).
    ItemSeries x, y, rotation, stress;
    /// Slip of the pairs (m), the largest of their contacts, and mobilised over peak roughness, the smallest.
    ItemSeries slip, roughness;
    std::vector<std::uint8_t> states;   ///< of the pairs, pair after pair
    std::vector<std::uint8_t> removed;  ///< of the blocks, block after block: 1 where it is excavated
};

/// Reads a run. @param frames that are kept. @throws InputError for frames of an older version, which do not
/// say which blocks a contact is between.
ReportMotion read_motion(const RunFrames& run, const std::vector<std::int64_t>& frames);

/// At most `most` frames of a run, equally spaced, with the first and the last, and no more than so many that
/// the page can be loaded.
std::vector<std::int64_t> report_frames(const RunFrames& run, std::size_t most);

}  // namespace rockslope
