#include "report_bytes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace rockslope::report_bytes_test {
namespace {

/// Reads what the page reads.
struct Reader {
    std::string bytes;
    std::size_t at = 0;

    std::uint64_t number() {
        std::uint64_t value = 0;
        for (int shift = 0;; shift += 7) {
            const auto byte = static_cast<unsigned char>(bytes.at(at++));
            value |= static_cast<std::uint64_t>(byte & 127) << shift;
            if (byte < 128) return value;
        }
    }
    std::int64_t number_with_sign() {
        const auto value = static_cast<std::int64_t>(number());
        return value % 2 != 0 ? -(value + 1) / 2 : value / 2;
    }
    float real() {
        std::uint32_t word = 0;
        for (int k = 0; k < 4; ++k)
            word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at++))) << (8 * k);
        return std::bit_cast<float>(word);
    }
};

TEST(ReportBytes, NumbersReadBack) {
    const std::vector<std::int64_t> values = {0, 1, -1, 63, -64, 64, 127, 128, -1'000'000, 1LL << 40};
    std::string bytes;
    for (const std::int64_t value : values) append_signed(bytes, value);
    EXPECT_EQ(bytes.substr(0, 5), std::string("\0\x02\x01\x7e\x7f", 5)) << "small numbers take a byte";
    Reader reader{bytes};
    for (const std::int64_t value : values) EXPECT_EQ(reader.number_with_sign(), value);
    EXPECT_EQ(reader.at, bytes.size());
}

TEST(ReportBytes, SeriesReadBackWithinHalfAStepOfEachItem) {
    constexpr std::size_t items = 4, frames = 50;
    constexpr int levels = 100;
    ItemSeries series{items, frames, std::vector<float>(items * frames)};
    std::mt19937 random(1);
    // A block that flies, one that moves a little, one at rest and one that moves less than is shown.
    const float sizes[] = {40.F, 1e-3F, 0.F, 1e-7F};
    for (std::size_t item = 0; item < items; ++item)
        for (std::size_t k = 0; k < frames; ++k)
            series.at(item, k) = sizes[item] * (static_cast<float>(random() % 2001) / 1000.F - 1.F);
    Reader reader{packed_series(series, {levels, 1e-6})};
    std::vector<float> steps(items);
    for (float& step : steps) step = reader.real();
    EXPECT_EQ(steps[2], 0);
    EXPECT_EQ(steps[3], 0);
    for (std::size_t item = 0; item < 2; ++item) {
        EXPECT_LE(steps[item], sizes[item] / levels * 1.001F);
        std::int64_t level = 0;
        for (std::size_t k = 0; k < frames; ++k) {
            level += reader.number_with_sign();
            EXPECT_NEAR(static_cast<float>(level) * steps[item], series.at(item, k), 0.501F * steps[item]);
        }
    }
    EXPECT_EQ(reader.at, reader.bytes.size()) << "items at rest take no more than their step";
}

TEST(ReportBytes, NoStepIsFinerThanTheFinest) {
    const ItemSeries series{3, 2, {0.F, 1.F, 0.F, 0.04F, 0.F, 0.004F}};
    Reader reader{packed_series(series, {.levels = 100, .finest = 0.01})};
    EXPECT_EQ(reader.real(), 0.01F);
    EXPECT_EQ(reader.real(), 0.01F) << "not 0.0004";
    EXPECT_EQ(reader.real(), 0) << "never half a step";
    for (const std::int64_t difference : {0, 100, 0, 4}) EXPECT_EQ(reader.number_with_sign(), difference);
    EXPECT_EQ(reader.at, reader.bytes.size());
}

TEST(ReportBytes, StatesReadBackAsRuns) {
    const std::vector<std::uint8_t> states = {3, 3, 3, 2, 1, 1, 0, 0, 0, 0};
    Reader reader{packed_states(states, 5)};
    std::vector<std::uint8_t> read;
    while (reader.at < reader.bytes.size()) {
        const std::uint64_t word = reader.number();
        read.insert(read.end(), word / 4 + 1, static_cast<std::uint8_t>(word % 4));
    }
    EXPECT_EQ(read, states);
    EXPECT_EQ(reader.bytes.size(), 5U) << "a run ends where an item ends";
}

TEST(ReportBytes, CompressedTextIsOfZlib) {
    const std::string bytes(10'000, 'a');
    const std::string text = compressed_text(bytes);
    EXPECT_LT(text.size(), 100U);
    EXPECT_EQ(text.substr(0, 2), "eN")
        << "the first byte of zlib's format at the best compression, in base64";
}

}  // namespace
}  // namespace rockslope::report_bytes_test
