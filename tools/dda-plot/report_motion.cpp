#include "report_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "common/base/input_error.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope {

namespace {

/// Blocks times frames that a page can hold.
constexpr std::size_t most_states = 10'000'000;

const std::vector<std::string> block_columns = {"displacement", "rotation", "principal_stress", "block",
                                                "material"};
const std::vector<std::string> contact_columns = {"block",          "other_block",     "state", "slip",
                                                  "joint_material", "mobilised_ratio", "joint"};

/// Collects the frames one by one.
class Collector {
  public:
    Collector(const RunFrames& run, const std::vector<std::int64_t>& frames) : run_(run) {
        motion_.frames = frames;
        add_blocks(run.blocks(frames.front(), block_columns, {"displacement"}));
        for (ItemSeries* series : {&motion_.x, &motion_.y, &motion_.rotation, &motion_.stress})
            prepare(*series, motion_.blocks.size());
        motion_.removed.assign(motion_.blocks.size() * frames.size(), 1);
    }

    ReportMotion collect() {
        find_pairs();
        for (ItemSeries* series : {&motion_.slip, &motion_.roughness}) prepare(*series, motion_.pairs.size());
        motion_.states.assign(motion_.pairs.size() * motion_.frames.size(), 0);
        for (std::size_t k = 0; k < motion_.frames.size(); ++k) {
            read_blocks(k);
            read_contacts(k);
        }
        return std::move(motion_);
    }

  private:
    void prepare(ItemSeries& series, std::size_t items) const {
        series = {items, motion_.frames.size(), std::vector<float>(items * motion_.frames.size())};
    }

    void add_blocks(const dda::GridFrame& frame) {
        const std::vector<float>& moved = frame.point_columns[0];
        for (std::size_t b = 0; b < frame.cells.count(); ++b) {
            ReportBlock block;
            block.number = static_cast<int>(frame.columns[3][b]);
            block.material = static_cast<int>(frame.columns[4][b]);
            block.moves = frame.columns.back()[b] == motion_free;
            for (auto k = frame.cells.offsets[b]; k < frame.cells.offsets[b + 1]; ++k) {
                const auto i =
                    3 * static_cast<std::size_t>(frame.cells.connectivity[static_cast<std::size_t>(k)]);
                block.corners.push_back({frame.points[i] - moved[i], frame.points[i + 1] - moved[i + 1]});
            }
            block.centroid = centroid(block.corners);
            index_[block.number] = motion_.blocks.size();
            motion_.blocks.push_back(std::move(block));
        }
    }

    void read_blocks(std::size_t k) {
        const dda::GridFrame frame = run_.blocks(motion_.frames[k], block_columns);
        const auto base = base_cell(frame);
        const Point moved =
            base ? Point{frame.columns[0][3 * *base], frame.columns[0][3 * *base + 1]} : Point{0, 0};
        motion_.base.push_back(moved);
        for (std::size_t cell = 0; cell < frame.cells.count(); ++cell) {
            const auto found = index_.find(static_cast<int>(frame.columns[3][cell]));
            if (found == index_.end()) continue;
            const std::size_t b = found->second;
            motion_.x.at(b, k) = frame.columns[0][3 * cell] - static_cast<float>(moved.x);
            motion_.y.at(b, k) = frame.columns[0][3 * cell + 1] - static_cast<float>(moved.y);
            motion_.rotation.at(b, k) = frame.columns[1][cell];
            motion_.stress.at(b, k) = frame.columns[2][2 * cell + 1];
            motion_.removed[b * motion_.frames.size() + k] = 0;
        }
    }

    /// The pair of a contact, or nothing for one of an unknown block.
    std::optional<std::pair<std::size_t, std::size_t>> blocks_of(const dda::GridFrame& contacts,
                                                                 std::size_t cell) const {
        const auto first = index_.find(static_cast<int>(contacts.columns[0][cell]));
        const auto second = index_.find(static_cast<int>(contacts.columns[1][cell]));
        if (first == index_.end() || second == index_.end()) return std::nullopt;
        return std::minmax(first->second, second->second);
    }

    /// Finds the pairs of all frames. Each gets the line between the farthest ends of its contacts in the
    /// frame where it is first seen.
    void find_pairs() {
        for (const std::int64_t index : motion_.frames) {
            const dda::GridFrame contacts = run_.contacts(index, contact_columns);
            std::map<std::size_t, std::vector<Point>> ends;  // of the pairs first seen in this frame
            for (std::size_t c = 0; c < contacts.cells.count(); ++c) {
                const std::vector<Point> line = cell_points(contacts, c);
                const auto key = blocks_of(contacts, c);
                if (!key || line.size() < 2) continue;
                const auto [entry, is_new] = pair_of_.try_emplace(*key, motion_.pairs.size());
                if (is_new) {
                    motion_.pairs.push_back(pair_of(*key, contacts, c));
                    ends[entry->second] = line;
                } else if (const auto found = ends.find(entry->second); found != ends.end()) {
                    found->second.insert(found->second.end(), line.begin(), line.end());
                }
            }
            if (!ends.empty()) place_lines(ends, run_.blocks(index, block_columns));
        }
    }

    /// A pair without a line. Its first block, which the line moves with, is the smaller one that moves.
    ReportPair pair_of(const std::pair<std::size_t, std::size_t>& key, const dda::GridFrame& contacts,
                       std::size_t cell) const {
        const auto rank = [&](std::size_t b) {
            const ReportBlock& block = motion_.blocks[b];
            double size = 0;
            for (const Point& p : block.corners)
                size = std::max(size, std::hypot(p.x - block.centroid.x, p.y - block.centroid.y));
            return std::pair(!block.moves, size);
        };
        const bool swaps = rank(key.second) < rank(key.first);
        return {swaps ? key.second : key.first,
                swaps ? key.first : key.second,
                static_cast<int>(contacts.columns[4][cell]),
                static_cast<int>(contacts.columns[6][cell]),
                {},
                {}};
    }

    /// Puts the lines of pairs where they were when displacements were zero. The rotation until now is left
    /// out.
    void place_lines(const std::map<std::size_t, std::vector<Point>>& ends, const dda::GridFrame& blocks) {
        std::unordered_map<std::size_t, Point> centroids;
        for (std::size_t c = 0; c < blocks.cells.count(); ++c)
            if (const auto found = index_.find(static_cast<int>(blocks.columns[3][c]));
                found != index_.end()) {
                const Point& origin = motion_.blocks[found->second].centroid;
                centroids[found->second] = {origin.x + blocks.columns[0][3 * c],
                                            origin.y + blocks.columns[0][3 * c + 1]};
            }
        for (const auto& [number, points] : ends) {
            ReportPair& pair = motion_.pairs[number];
            const Point& middle = centroids.at(pair.block);
            double farthest = -1;
            for (const Point& p : points)
                for (const Point& q : points) {
                    const double distance = std::hypot(p.x - q.x, p.y - q.y);
                    if (distance <= farthest) continue;
                    farthest = distance;
                    pair.from = {p.x - middle.x, p.y - middle.y};
                    pair.to = {q.x - middle.x, q.y - middle.y};
                }
        }
    }

    void read_contacts(std::size_t k) {
        const dda::GridFrame contacts = run_.contacts(motion_.frames[k], contact_columns);
        const std::size_t frames = motion_.frames.size();
        constexpr float none = std::numeric_limits<float>::infinity();
        std::vector<float> roughness(motion_.pairs.size(), none);
        if (k > 0)
            for (std::size_t p = 0; p < motion_.pairs.size(); ++p)
                motion_.slip.at(p, k) = motion_.slip.at(p, k - 1);
        std::vector<float> slip(motion_.pairs.size(), -1);
        for (std::size_t c = 0; c < contacts.cells.count(); ++c) {
            const auto key = blocks_of(contacts, c);
            const auto found = key ? pair_of_.find(*key) : pair_of_.end();
            if (found == pair_of_.end()) continue;
            const std::size_t p = found->second;
            std::uint8_t& state = motion_.states[p * frames + k];
            state = stronger(state, contacts.columns[2][c]);
            slip[p] = std::max(slip[p], std::abs(contacts.columns[3][c]));
            const float ratio = std::abs(contacts.columns[5][c]);
            if (ratio > 0) roughness[p] = std::min(roughness[p], ratio);
        }
        for (std::size_t p = 0; p < motion_.pairs.size(); ++p) {
            if (slip[p] >= 0) motion_.slip.at(p, k) = slip[p];
            if (roughness[p] < none) motion_.roughness.at(p, k) = roughness[p];
        }
    }

    /// The state of a pair with one more contact: sliding, where one slides; locked, where one is.
    static std::uint8_t stronger(std::uint8_t state, float contact) {
        const auto own = contact == state_open      ? PairState::open
                         : contact == state_sliding ? PairState::sliding
                                                    : PairState::locked;
        const auto before = static_cast<PairState>(state);
        if (before == PairState::sliding || own == PairState::sliding)
            return static_cast<std::uint8_t>(PairState::sliding);
        return std::max(state, static_cast<std::uint8_t>(own));
    }

    const RunFrames& run_;
    ReportMotion motion_;
    std::unordered_map<int, std::size_t> index_;  ///< of a block, by its number
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> pair_of_;
};

}  // namespace

std::vector<std::int64_t> report_frames(const RunFrames& run, std::size_t most) {
    const std::size_t count = run.times().size();
    const std::size_t blocks = std::max<std::size_t>(run.blocks(0).cells.count(), 1);
    const std::size_t kept = std::min({count, most, std::max<std::size_t>(most_states / blocks, 2)});
    std::vector<std::int64_t> frames;
    for (std::size_t k = 0; k < kept; ++k)
        frames.push_back(static_cast<std::int64_t>(kept == 1 ? 0 : k * (count - 1) / (kept - 1)));
    return frames;
}

ReportMotion read_motion(const RunFrames& run, const std::vector<std::int64_t>& frames) {
    if (!run.has_point_displacements())
        throw InputError({run.name() + ".vtkhdf"}, "has no displacements of corners, which a report needs",
                         "the frames of this version of dda-run");
    return Collector(run, frames).collect();
}

}  // namespace rockslope
