#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rockslope {

/// The values of several items over the frames, item after item.
struct ItemSeries {
    std::size_t items = 0, frames = 0;
    std::vector<float> values;

    float& at(std::size_t item, std::size_t frame) { return values[item * frames + frame]; }
};

/// Whole numbers as bytes of seven bits each, the lowest first (LEB128), those with a sign in zigzag order.
void append_number(std::string& bytes, std::uint64_t value);
void append_signed(std::string& bytes, std::int64_t value);

/// How finely a series is kept.
struct Resolution {
    int levels = 1;       ///< steps from zero to the largest magnitude of an item
    double smallest = 0;  ///< magnitude below which an item is zero, in the unit of the series
    double finest = 0;    ///< smallest step of any item
};

/// A series in equal steps for each item: the steps of all items as little-endian floats, then for each item
/// whose step is not zero the differences from frame to frame, as signed numbers.
std::string packed_series(const ItemSeries& series, const Resolution& resolution);

/// States from 0 to 3 of several items over the frames, item after item, as runs: four times the number of
/// frames less one, plus the state.
std::string packed_states(const std::vector<std::uint8_t>& states, std::size_t frames);

/// The bytes in the format of zlib (RFC 1950), in base64.
std::string compressed_text(const std::string& bytes);

}  // namespace rockslope
