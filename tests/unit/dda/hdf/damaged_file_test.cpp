#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "common/base/atomic_file.hpp"
#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"
#include "dda/hdf/library_guard.hpp"
#include "dda/hdf/vtkhdf_file.hpp"
#include "support/error_of.hpp"
#include "support/sanitized.hpp"

namespace rockslope::damaged_file_test {
namespace {

using namespace dda;
namespace fs = std::filesystem;

class DamagedFile : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("damaged_file_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        path = folder_ / "frames.vtkhdf";
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path path;

  private:
    fs::path folder_;
};

/// Two frames of a triangle.
void write_frames(const fs::path& path) {
    GridCells cells;
    cells.offsets = {0};
    cells.add({0, 1, 2}, 7);
    GridLayout layout;
    layout.columns = {{"displacement", 3}, {"stress", 1}};
    VtkHdfFile file(path, layout, cells, 3);
    for (const double time : {0.0, 0.5})
        file.append({.time = time,
                     .stage = "settle",
                     .points = {0, 0, 0, 1, 0, 0, 0, 1, 0},
                     .columns = {{1, 2, 3}, {4}}});
}

/// The address sanitizer ends a process where the library reads beyond its buffers. It writes nothing there.
enum Outcome { read_whole, refused, other_error, sanitizer_report };

Outcome read_all(const fs::path& path) {
    try {
        const VtkHdfReader reader(path);
        reader.digest(reader.frame_count());
        return read_whole;
    } catch (const OutputError&) {
        return refused;
    } catch (...) {
        return other_error;
    }
}

/// Reads files one after the other, in a process of their own until the library fails, for it cannot be
/// used again.
/// @param write_file writes file k at `path`.
/// @return for the first files, at least one, the outcome, or minus the signal that ended the process.
std::vector<int> outcomes_in_one_process(const fs::path& path, std::size_t first, std::size_t end,
                                         const std::function<void(std::size_t)>& write_file) {
    int ends[2];
    if (::pipe(ends) != 0) return {other_error};
    const pid_t child = ::fork();
    if (child == 0) {
        for (std::size_t k = first; k < end && !library_has_failed(); ++k) {
            ::alarm(20);
            write_file(k);
            const char outcome = static_cast<char>(read_all(path));
            if (::write(ends[1], &outcome, 1) != 1) break;
        }
        ::_exit(0);
    }
    ::close(ends[1]);
    std::vector<int> outcomes;
    for (char outcome; ::read(ends[0], &outcome, 1) == 1;) outcomes.push_back(outcome);
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status))
        outcomes.push_back(-WTERMSIG(status));
    else if (WEXITSTATUS(status) != 0)
        outcomes.push_back(sanitizer_report);
    if (outcomes.empty()) outcomes.push_back(other_error);
    return outcomes;
}

/// The outcomes of reading `count` files, each written at `path` before it is read.
std::vector<int> outcomes_of_reading(const fs::path& path, std::size_t count,
                                     const std::function<void(std::size_t)>& write_file) {
    std::vector<int> all;
    while (all.size() < count)
        for (const int outcome : outcomes_in_one_process(path, all.size(), count, write_file))
            all.push_back(outcome);
    return all;
}

int outcome_of_reading(const fs::path& path) {
    return outcomes_of_reading(path, 1, [](std::size_t) {}).front();
}

// HDF5 1.10 divides by zero where a chunk has no rows: dda-plot died of SIGFPE.
TEST_F(DamagedFile, IsReadOrRefusedWhateverByteIsZero) {
    write_frames(path);
    ASSERT_EQ(outcome_of_reading(path), read_whole);
    const std::string whole = read_text_file(path);
    const std::size_t end = std::min<std::size_t>(whole.size(), 14000);  // the headers of the datasets
    std::vector<std::size_t> places;
    for (std::size_t at = 0; at < end; at += 2)
        if (whole[at] != 0) places.push_back(at);
    const std::vector<int> outcomes = outcomes_of_reading(path, places.size(), [&](std::size_t k) {
        std::string damaged = whole;
        damaged[places[k]] = 0;
        std::ofstream(path, std::ios::binary) << damaged;
    });
    int refusals = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (outcomes[k] == sanitizer_report && libraries_are_sanitized()) continue;
        ASSERT_THAT(outcomes[k], testing::AnyOf(read_whole, refused)) << "byte " << places[k];
        refusals += outcomes[k] == refused ? 1 : 0;
    }
    EXPECT_GT(refusals, 100);
}

/// One frame of a triangle as no program writes it.
void write_numbers(const fs::path& path, double time, double coordinate, float stress) {
    HdfFile file = HdfFile::create(path);
    const std::string root = "/VTKHDF/", steps = root + "Steps/";
    for (const char* group : {"/VTKHDF", "/VTKHDF/CellData", "/VTKHDF/PointData", "/VTKHDF/Steps",
                              "/VTKHDF/Steps/CellDataOffsets"})
        file.add_group(group);
    const auto add = [&](const std::string& name, HdfType type, const auto& values) {
        file.add_dataset(name, type, 1, 4, false);
        file.append(name, values);
    };
    for (const char* name : {"PartOffsets", "NumberOfParts", "PointOffsets", "CellOffsets",
                             "ConnectivityIdOffsets", "CellDataOffsets/stress"})
        add(steps + name, HdfType::i8, std::vector<std::int64_t>{0});
    add(steps + "Values", HdfType::f8, std::vector<double>{time});
    add(root + "NumberOfPoints", HdfType::i8, std::vector<std::int64_t>{3});
    add(root + "NumberOfCells", HdfType::i8, std::vector<std::int64_t>{1});
    add(root + "NumberOfConnectivityIds", HdfType::i8, std::vector<std::int64_t>{3});
    add(root + "Connectivity", HdfType::i8, std::vector<std::int64_t>{0, 1, 2});
    add(root + "Offsets", HdfType::i8, std::vector<std::int64_t>{0, 3});
    add(root + "Types", HdfType::u1, std::vector<std::uint8_t>{7});
    add(root + "CellData/stress", HdfType::f4, std::vector<float>{stress});
    file.add_dataset(root + "Points", HdfType::f8, 3, 4, false);
    file.append(root + "Points", std::vector<double>{0, 0, 0, coordinate, 0, 0, 0, 1, 0});
    file.set_attribute("/VTKHDF/Steps", "NSteps", std::int64_t{1});
}

// An object of no size in a heap of texts: HDF5 1.10 went round in it, and dda-plot never ended.
TEST_F(DamagedFile, IsLeftWhereTheLibraryDoesNotEnd) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(20);
        const auto goes_round = [](void*) {
            for (volatile bool goes_on = true; goes_on;) {
            }
        };
        const bool is_left = !survives(goes_round, nullptr, 0.05);
        ::_exit(is_left && library_has_failed() ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    EXPECT_TRUE(survives([](void* data) { *static_cast<int*>(data) = 0; }, &status));
}

// A coordinate beyond all bounds, of a damaged file, ended dda-plot by "drawing failed", code 1.
TEST_F(DamagedFile, HasNumbersThatAreFinite) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    write_numbers(path, 0.5, 1, 2);
    EXPECT_EQ(outcome_of_reading(path), read_whole);
    for (const double wrong : {infinity, -infinity, nan}) {
        write_numbers(path, wrong, 1, 2);
        EXPECT_EQ(outcome_of_reading(path), refused) << "time";
        write_numbers(path, 0.5, wrong, 2);
        EXPECT_EQ(outcome_of_reading(path), refused) << "coordinate";
        write_numbers(path, 0.5, 1, static_cast<float>(wrong));
        EXPECT_EQ(outcome_of_reading(path), refused) << "stress";
    }
    GridCells cells;
    cells.add({0, 1, 2}, 7);
    GridLayout layout;
    layout.columns = {{"stress", 1}};
    VtkHdfFile file(path, layout, cells, 3);
    EXPECT_THROW(file.append({.points = {1e39, 0, 0, 1, 0, 0, 0, 1, 0}, .columns = {{4}}}), OutputError)
        << "a coordinate that single precision does not hold";
}

// Of frames that are written and read again, whatever their order of columns; any other number shows.
TEST_F(DamagedFile, HasTheDigestOfItsFrames) {
    const fs::path other = path.string() + ".other";
    const auto digest_of = [](const fs::path& file, std::int64_t frames) {
        return VtkHdfReader(file).digest(frames);
    };
    write_numbers(path, 0.5, 1, 2);
    const std::string digest = digest_of(path, 1);
    write_numbers(other, 0.5, 1, 2);
    EXPECT_EQ(digest_of(other, 1), digest);
    write_numbers(other, 0.5, 1, 3);
    EXPECT_NE(digest_of(other, 1), digest) << "stress";
    write_numbers(other, 0.5, 1.5, 2);
    EXPECT_NE(digest_of(other, 1), digest) << "coordinate";
    write_numbers(other, 0.25, 1, 2);
    EXPECT_NE(digest_of(other, 1), digest) << "time";
    EXPECT_NE(digest_of(path, 0), digest) << "number of frames";

    GridCells cells;
    cells.add({0, 1, 2}, 7);
    const GridFrame frame{.time = 0.1,
                          .stage = "settle",
                          .points = {0.1, 0, 0, 1, 0, 0, 0, 1, 0},
                          .columns = {{1, 2, 3}, {4}},
                          .point_columns = {{1, 2, 3}},
                          .cells = cells};
    for (const HdfType points : {HdfType::f4, HdfType::f8})
        for (const bool fixed : {true, false}) {
            const GridLayout layout{{{"z", 3}, {"a", 1}}, {{"m", 1}}, {}, points};
            VtkHdfFile file = fixed ? VtkHdfFile(path, layout, cells, 3) : VtkHdfFile(path, layout, 1);
            file.append(frame);
            file.append(frame);
            EXPECT_EQ(file.digest(), digest_of(path, 2)) << fixed;
        }
}

// A text that says to have 4 GB: they were allocated, and dda-plot held them, before the file was refused.
TEST_F(DamagedFile, HasNoTextsLongerThanItself) {
    write_frames(path);
    EXPECT_EQ(VtkHdfReader(path).stages(), (std::vector<std::string>{"settle", "settle"}));
    std::string bytes = read_text_file(path);
    // The length of "settle" in the dataset of stages; behind it are the address of a heap and a number
    // there.
    const std::string length("\6\0\0\0", 4);
    int damaged = 0;
    for (std::size_t at = bytes.find(length); at != std::string::npos; at = bytes.find(length, at + 1)) {
        std::uint64_t address = 0;
        std::uint32_t number = 0;
        if (at + 16 > bytes.size()) break;
        std::memcpy(&address, &bytes[at + 4], sizeof address);
        std::memcpy(&number, &bytes[at + 12], sizeof number);
        if (address == 0 || address >= bytes.size() || number == 0 || number > 9) continue;
        if (bytes.compare(address, 4, "GCOL") != 0) continue;
        bytes[at + 3] = '\xff';
        ++damaged;
    }
    ASSERT_EQ(damaged, 1);
    std::ofstream(path, std::ios::binary) << bytes;
    EXPECT_THAT(error_of<OutputError>([&] { VtkHdfReader{path}; }),
                testing::HasSubstr("dataset /VTKHDF/FieldData/stage declares longer texts than it holds"));
}

// A number that says to have 1.8 GB: the library allocated a buffer for one, and dda-plot held it.
TEST_F(DamagedFile, HasNoNumbersLargerThanEightBytes) {
    write_numbers(path, 0.5, 1, 2);
    const std::string whole = read_text_file(path);
    // An integer of 64 bits as HDF5 describes it: its class, three bytes of flags, its size in bytes, ...;
    // behind it the rows of a chunk and, again, the size.
    const std::string integer("\x10\x08\0\0\x08\0\0\0\0\0\x40\0", 12);
    const std::string chunk("\4\0\0\0\x08\0\0\0", 8);
    int refusals = 0;
    for (std::size_t at = whole.find(integer); at != std::string::npos; at = whole.find(integer, at + 1)) {
        const std::size_t behind = whole.find(chunk, at);
        if (behind == std::string::npos || behind - at > 200) continue;
        std::string damaged = whole;
        damaged[at + 7] = damaged[behind + 7] = '\x10';
        std::ofstream(path, std::ios::binary) << damaged;
        const std::string error = error_of<OutputError>([&] { VtkHdfReader(path).digest(1); });
        if (error == "no error") continue;
        EXPECT_THAT(error, testing::HasSubstr(" does not hold numbers of at most 8 bytes"));
        ++refusals;
    }
    EXPECT_EQ(refusals, 10) << "the datasets of integers but for NumberOfParts, which is not read";
}

TEST_F(DamagedFile, DeclaresNoMoreThanItHolds) {
    {
        HdfFile file = HdfFile::create(path);
        file.add_dataset("/many", HdfType::f8, 1, std::size_t{1} << 20, true);
        file.append("/many", std::vector<double>(std::size_t{1} << 20));
        file.add_dataset("/texts", HdfType::i8, 1, 4, false);
        file.append("/texts", std::vector<std::int64_t>{1, 2, 3});
        file.set_attribute("/", "numbers", std::vector<std::int64_t>(1000, 7));
    }
    const HdfFile file = HdfFile::open_to_read(path);
    EXPECT_EQ(file.read_all<double>("/many").size(), std::size_t{1} << 20) << "deflated zeros are believed";
    EXPECT_THROW(file.integer_attribute("/", "numbers"), OutputError) << "a thousand numbers are not one";
    EXPECT_THROW(file.string_attribute("/", "numbers"), OutputError);
    EXPECT_THROW(file.read_texts("/texts"), OutputError);
    EXPECT_THROW(file.read<double>("/many", 5, std::numeric_limits<std::size_t>::max()), OutputError);
}

}  // namespace
}  // namespace rockslope::damaged_file_test
