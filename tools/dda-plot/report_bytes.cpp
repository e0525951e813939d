#include "report_bytes.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "common/base/base64.hpp"

namespace rockslope {

namespace {

void append_float(std::string& bytes, float value) {
    const auto word = std::bit_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((word >> shift) & 0xff);
}

}  // namespace

void append_number(std::string& bytes, std::uint64_t value) {
    for (; value >= 128; value >>= 7) bytes += static_cast<char>((value & 127) | 128);
    bytes += static_cast<char>(value);
}

void append_signed(std::string& bytes, std::int64_t value) {
    append_number(bytes, static_cast<std::uint64_t>(value < 0 ? -2 * value - 1 : 2 * value));
}

std::string packed_series(const ItemSeries& series, const Resolution& resolution) {
    std::string steps, differences;
    for (std::size_t item = 0; item < series.items; ++item) {
        const auto begin = series.values.begin() + static_cast<std::ptrdiff_t>(item * series.frames);
        const auto end = begin + static_cast<std::ptrdiff_t>(series.frames);
        float largest = 0;
        for (auto value = begin; value != end; ++value) largest = std::max(largest, std::abs(*value));
        const float own =
            std::max(largest / static_cast<float>(resolution.levels), static_cast<float>(resolution.finest));
        const float step = largest > resolution.smallest && largest >= own / 2 ? own : 0;
        append_float(steps, step);
        if (step == 0) continue;
        std::int64_t before = 0;
        for (auto value = begin; value != end; ++value) {
            const std::int64_t level = std::llround(*value / step);
            append_signed(differences, level - before);
            before = level;
        }
    }
    return steps + differences;
}

std::string packed_states(const std::vector<std::uint8_t>& states, std::size_t frames) {
    std::string bytes;
    for (std::size_t start = 0; start < states.size(); start += frames)
        for (std::size_t k = 0; k < frames;) {
            std::size_t end = k + 1;
            while (end < frames && states[start + end] == states[start + k]) ++end;
            append_number(bytes, 4 * (end - k - 1) + states[start + k]);
            k = end;
        }
    return bytes;
}

std::string compressed_text(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION) != Z_OK)
        throw std::runtime_error("the report cannot be compressed");
    packed.resize(size);
    return base64(packed);
}

}  // namespace rockslope
