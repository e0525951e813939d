#include "dda/checkpoint/checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>

#include "common/base/atomic_file.hpp"
#include "common/base/input_error.hpp"
#include "common/base/sha256.hpp"
#include "dda/checkpoint/state_archive.hpp"
#include "dda/hdf/hdf.hpp"
#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t checkpoint_version = 21;
constexpr std::size_t chunk_elements = 1 << 16;  // elements

template <class T>
void store(HdfFile& file, const std::string& name, const std::vector<T>& values) {
    file.add_dataset(name, hdf_type_of<T>(), 1,
                     std::min(std::max<std::size_t>(values.size(), 1), chunk_elements), false);
    file.append(name, values);
}

std::vector<double> peak_values(const std::vector<Peaks>& peaks) {
    std::vector<double> values;
    for (const Peaks& p : peaks)
        values.insert(values.end(),
                      {p.displacement, p.displacement_time, p.velocity, p.velocity_time, p.acceleration,
                       p.acceleration_time, p.relative, p.relative_time, p.smooth_acceleration,
                       p.smooth.first.x(), p.smooth.first.y(), p.smooth.second.x(), p.smooth.second.y()});
    return values;
}

std::vector<Peaks> peaks_of(const std::vector<double>& values) {
    std::vector<Peaks> peaks;
    constexpr std::size_t width = 13;
    for (std::size_t i = 0; i + width <= values.size(); i += width) {
        const double* p = &values[i];
        peaks.push_back(
            {p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], {Vec2(p[9], p[10]), Vec2(p[11], p[12])}});
    }
    return peaks;
}

std::vector<double> region_values(const std::vector<RegionPeaks>& regions) {
    std::vector<double> values;
    for (const RegionPeaks& r : regions)
        values.insert(values.end(), {r.mean, r.mean_time, r.largest, r.largest_time});
    return values;
}

std::vector<RegionPeaks> regions_of(const std::vector<double>& values) {
    std::vector<RegionPeaks> regions;
    for (std::size_t i = 0; i + 4 <= values.size(); i += 4)
        regions.push_back({values[i], values[i + 1], values[i + 2], values[i + 3]});
    return regions;
}

std::vector<double> farthest_values(const std::optional<FarthestBlock>& farthest) {
    if (!farthest) return {};
    return {static_cast<double>(farthest->block.value()), farthest->displacement, farthest->time};
}

/// An integer that is stored as a real. @throws std::runtime_error when it is none.
template <class Integer = int>
Integer integer_of(double value) {
    constexpr double largest = std::is_same_v<Integer, int> ? 2147483647.0 : 0x1p53;
    if (!(std::abs(value) <= largest) || value != std::trunc(value))
        throw std::runtime_error("a number of it is no index");
    return static_cast<Integer>(value);
}

std::optional<FarthestBlock> farthest_of(const std::vector<double>& values) {
    if (values.size() < 3) return std::nullopt;
    return FarthestBlock{integer_of(values[0]), values[1], values[2]};
}

std::vector<double> slip_values(const std::vector<FirstSlip>& slips) {
    std::vector<double> values;
    for (const FirstSlip& s : slips)
        values.insert(values.end(),
                      {s.sliding_since, s.time, s.dynamic_time, static_cast<double>(s.other.value()),
                       static_cast<double>(s.joint_material.value())});
    return values;
}

PerBlock<FirstSlip> slips_of(const std::vector<double>& values) {
    PerBlock<FirstSlip> slips;
    for (std::size_t i = 0; i + 5 <= values.size(); i += 5)
        slips.push_back(
            {values[i], values[i + 1], values[i + 2], integer_of(values[i + 3]), integer_of(values[i + 4])});
    return slips;
}

std::vector<double> plane_values(const std::vector<BlockOnPlane>& planes) {
    std::vector<double> values;
    for (const BlockOnPlane& p : planes)
        values.insert(values.end(),
                      {static_cast<double>(p.block.value()), static_cast<double>(p.base.value()),
                       p.downhill.x(), p.downhill.y(), p.dip, p.peak.friction, p.peak.adhesion,
                       p.residual.friction, p.residual.adhesion});
    return values;
}

std::vector<BlockOnPlane> planes_of(const std::vector<double>& values) {
    std::vector<BlockOnPlane> planes;
    for (std::size_t i = 0; i + 9 <= values.size(); i += 9)
        planes.push_back({integer_of(values[i]),
                          integer_of(values[i + 1]),
                          {values[i + 2], values[i + 3]},
                          values[i + 4],
                          {values[i + 5], values[i + 6]},
                          {values[i + 7], values[i + 8]}});
    return planes;
}

std::vector<double> reversal_values(const std::vector<CloseReversal>& reversals) {
    std::vector<double> values;
    for (const CloseReversal& r : reversals)
        values.insert(
            values.end(),
            {r.time, static_cast<double>(r.joint.first.value()), static_cast<double>(r.joint.second.value()),
             static_cast<double>(r.joint.joint_material.value()), r.joint.at.x(), r.joint.at.y(),
             r.joint.slip.amount, r.joint.slip.least, r.joint.slip.counted ? 1.0 : 0.0});
    return values;
}

/// All of them have ended: a checkpoint has no others.
std::vector<CloseReversal> reversals_of(const std::vector<double>& values) {
    std::vector<CloseReversal> reversals;
    for (std::size_t i = 0; i + 9 <= values.size(); i += 9)
        reversals.push_back({values[i],
                             {integer_of(values[i + 1]),
                              integer_of(values[i + 2]),
                              integer_of(values[i + 3]),
                              {values[i + 4], values[i + 5]},
                              {values[i + 6], values[i + 7], values[i + 8] != 0}}});
    return reversals;
}

std::vector<double> trial_values(const std::vector<ReductionTrial>& trials) {
    std::vector<double> values;
    for (const ReductionTrial& t : trials)
        values.insert(values.end(), {t.factor, t.stands ? 1.0 : 0.0, static_cast<double>(t.steps),
                                     t.unbalanced_force, t.displacement});
    return values;
}

std::vector<ReductionTrial> trials_of(const std::vector<double>& values) {
    std::vector<ReductionTrial> trials;
    for (std::size_t i = 0; i + 5 <= values.size(); i += 5)
        trials.push_back({values[i], values[i + 1] != 0, integer_of<std::int64_t>(values[i + 2]),
                          values[i + 3], values[i + 4]});
    return trials;
}

std::vector<double> left_values(const std::vector<LeftMoving>& left) {
    std::vector<double> values;
    for (const LeftMoving& l : left)
        values.insert(values.end(), {static_cast<double>(l.stage), static_cast<double>(l.block.value()),
                                     l.centroid.x(), l.centroid.y(), l.mass, l.share, l.displacement});
    return values;
}

std::vector<LeftMoving> left_of(const std::vector<double>& values) {
    std::vector<LeftMoving> left;
    for (std::size_t i = 0; i + 7 <= values.size(); i += 7)
        left.push_back({integer_of(values[i]),
                        integer_of(values[i + 1]),
                        {values[i + 2], values[i + 3]},
                        values[i + 4],
                        values[i + 5],
                        values[i + 6]});
    return left;
}

std::vector<std::int64_t> counts_of(const ResultsState& results) {
    return {results.stage,
            results.next_frame,
            results.next_history,
            results.last_frame_step,
            results.last_history_step,
            results.fallbacks,
            results.close_reversals.counted,
            results.close_reversals.not_counted};
}

/// The scalar reals of the results.
std::vector<double> reals_of(const ResultsState& results) {
    return {results.wall_time, results.remaining_dilation};
}

void write_results_state(HdfFile& file, const ResultsState& results) {
    store(file, "/results", counts_of(results));
    store(file, "/figures", reals_of(results));
    store(file, "/peaks", peak_values(results.peaks));
    store(file, "/regions", region_values(results.regions));
    store(file, "/farthest", farthest_values(results.farthest));
    store(file, "/trials", trial_values(results.trials));
    store(file, "/first_slips", slip_values(results.first_slips));
    store(file, "/planes", plane_values(results.planes));
    store(file, "/close_reversals", reversal_values(results.close_reversals.nearest));
    store(file, "/left_moving", left_values(results.left_moving));
}

ResultsState read_results_state(const HdfFile& file) {
    const auto counts = file.read<std::int64_t>("/results", 0, 8);
    const auto figures = file.read<double>("/figures", 0, 2);
    ResultsState results;
    if (!std::in_range<int>(counts[0])) throw std::runtime_error("the number of its stage is none");
    results.stage = static_cast<int>(counts[0]);
    results.next_frame = counts[1];
    results.next_history = counts[2];
    results.last_frame_step = counts[3];
    results.last_history_step = counts[4];
    results.fallbacks = counts[5];
    results.close_reversals.counted = counts[6];
    results.close_reversals.not_counted = counts[7];
    results.wall_time = figures[0];
    results.remaining_dilation = figures[1];
    results.peaks = peaks_of(file.read_all<double>("/peaks"));
    results.regions = regions_of(file.read_all<double>("/regions"));
    results.farthest = farthest_of(file.read_all<double>("/farthest"));
    results.trials = trials_of(file.read_all<double>("/trials"));
    results.first_slips = slips_of(file.read_all<double>("/first_slips"));
    results.planes = planes_of(file.read_all<double>("/planes"));
    results.close_reversals.nearest = reversals_of(file.read_all<double>("/close_reversals"));
    results.left_moving = left_of(file.read_all<double>("/left_moving"));
    return results;
}

/// Ends a checkpoint: the digest of all bytes before it. HDF5 does not detect a damaged number, a wrong index
/// in a state would corrupt memory, and the library itself fails on damaged bytes.
constexpr std::string_view seal_mark = "\nsha256 ";
constexpr std::size_t seal_length = seal_mark.size() + 64;

/// What a checkpoint of so many bytes before it ends with. @throws OutputError.
std::string seal_of(const fs::path& path, std::uintmax_t length) {
    return std::string(seal_mark) + sha256_of_beginning(path, length).digest();
}

/// @throws std::runtime_error unless the file ends with the digest of the bytes before.
void check_seal(const fs::path& path) {
    std::error_code error;
    const std::uintmax_t size = fs::is_regular_file(path, error) ? fs::file_size(path, error) : 0;
    if (error || size < seal_length) throw std::runtime_error("it is no whole checkpoint");
    std::ifstream file(path, std::ios::binary);
    std::string seal(seal_length, '\0');
    file.seekg(static_cast<std::streamoff>(size - seal_length));
    file.read(seal.data(), static_cast<std::streamsize>(seal_length));
    if (!seal.starts_with(seal_mark)) throw std::runtime_error("it does not end with its digest");
    if (seal != seal_of(path, size - seal_length)) throw std::runtime_error("the file is damaged");
}

void write_content(HdfFile& file, const Checkpoint& checkpoint) {
    const StateArchive state = archive(checkpoint.state);
    file.reserve(8 * (state.reals.size() + state.integers.size()) + state.bytes.size() + (1 << 18));
    file.set_attribute("/", "version", checkpoint_version);
    file.set_attribute("/", "input_hash", checkpoint.input_hash);
    store(file, "/start_of_run",
          std::vector<std::uint8_t>(checkpoint.start_of_run.begin(), checkpoint.start_of_run.end()));
    store(file, "/reals", state.reals);
    store(file, "/integers", state.integers);
    store(file, "/bytes", state.bytes);
    write_results_state(file, checkpoint.results);
    file.add_group("/positions");
    for (const auto& [name, position] : checkpoint.positions)
        file.set_attribute("/positions", name, position);
    file.add_group("/digests");
    for (const auto& [name, digest] : checkpoint.digests) file.set_attribute("/digests", name, digest);
    file.flush();
}

Checkpoint read_content(const HdfFile& file) {
    const std::int64_t version = file.integer_attribute("/", "version");
    if (version != checkpoint_version)
        throw std::runtime_error("the checkpoint has version " + std::to_string(version));
    Checkpoint checkpoint;
    checkpoint.input_hash = file.string_attribute("/", "input_hash");
    const auto start = file.read_all<std::uint8_t>("/start_of_run");
    checkpoint.start_of_run.assign(start.begin(), start.end());
    checkpoint.results = read_results_state(file);
    for (const WriterEntry& writer : writer_table()) {
        if (file.has_attribute("/positions", writer.name))
            checkpoint.positions[writer.name] = file.integer_attribute("/positions", writer.name);
        if (file.has_attribute("/digests", writer.name))
            checkpoint.digests[writer.name] = file.string_attribute("/digests", writer.name);
    }
    checkpoint.state = restore({file.read_all<double>("/reals"), file.read_all<std::int64_t>("/integers"),
                                file.read_all<std::uint8_t>("/bytes")});
    return checkpoint;
}

}  // namespace

void write_checkpoint(const fs::path& path, const Checkpoint& checkpoint) {
    PendingFile pending(path);
    {
        HdfFile file = HdfFile::create(pending.temporary());
        write_content(file, checkpoint);
    }
    pending.append(seal_of(pending.temporary(), fs::file_size(pending.temporary())));
    pending.put_in_place();
}

Checkpoint read_checkpoint(const fs::path& path) {
    if (!fs::exists(path))
        throw InputError({path.string()}, "there is no checkpoint to resume from",
                         "the output folder of a run that was stopped");
    try {
        check_seal(path);
        return read_content(HdfFile::open_to_read(path));
    } catch (const std::runtime_error& error) {
        throw InputError({path.string()}, std::string("cannot be resumed from: ") + error.what(),
                         "a checkpoint written by this version of dda-run");
    }
}

}  // namespace rockslope::dda
