#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

/// Small files in every format, laid out as by their providers.
namespace rockslope::small_records {

/// Numbers in fields of the width in `format`, `per_line` to a line.
template <class Number>
std::string fields(const std::vector<Number>& numbers, std::size_t per_line, const char* format) {
    std::string text;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        char field[64];
        std::snprintf(field, sizeof field, format, numbers[k]);
        text += field;
        if (k % per_line == per_line - 1 || k + 1 == numbers.size()) text += '\n';
    }
    return text;
}

inline const std::vector<double> ten = {-3.038, -0.787, 2.288, 4.106,  4.898,
                                        3.777,  0.63,   -1.08, -2.112, -5.659};

inline std::string peer() {
    return "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere\nACCELERATION TIME SERIES IN UNITS OF G\n"
           "NPTS=     10, DT=   .0200 SEC,\n" +
           fields(ten, 5, "%15.7E");
}

/// 10 samples at 100 Hz; the mean of the counts is 5.
inline std::string knet() {
    std::string text =
        "Origin Time       2020/01/02 03:04:00\nLat.              41.0\nLong.             142.5\n"
        "Depth. (km)       30\nMag.              6.2\nStation Code      ABC001\nStation Lat.      41.4\n"
        "Station Long.     141.4\nStation Height(m) 30\nRecord Time       2020/01/02 03:04:37\n"
        "Sampling Freq(Hz) 100Hz\nDuration Time(s)  0.1\nDir.              E-W\n"
        "Scale Factor      3920(gal)/1000\nMax. Acc. (gal)   392.000\n"
        "Last Correction   2020/01/02 03:04:37\nMemo.             \n";
    return text + fields(std::vector<int>{5, 105, -95, 5, 15, -5, 5, 5, 6, 4}, 8, "%9d");
}

/// A channel of COSMOS V1.20 in fields without separators.
inline std::string cosmos_channel(const char* announced, int quantity, const char* unit) {
    std::vector<int> integers(100, -999);
    integers[0] = 2;
    integers[1] = quantity;
    std::vector<double> reals(100, -999);
    reals[61] = 20;     // ms
    reals[33] = 0.005;  // s, step of the raw record, which must not be read
    std::string text = "Corrected acceleration    (Format v01.20 with 13 text lines)\n";
    for (int line = 2; line <= 13; ++line) text += "text\n";
    text += " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" + fields(integers, 10, "%8d") +
            " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n" + fields(reals, 6, "%13.6f") +
            "  1 Comment line(s) follow, each starting with a \"|\":\n | a comment\n     10  " + announced +
            " pts, approx    0 secs, units=" + unit + ",Format=(8F7.3)\n" + fields(ten, 8, "%7.3f") +
            "/&  ----------  End of data for channel  1  ----------\n";
    return text;
}

inline std::string cosmos() {
    return cosmos_channel("acceleration", 1, "cm/sec2(04)") + cosmos_channel("velocity", 2, "cm/sec(05)") +
           cosmos_channel("acceleration", 1, "g(02)");
}

inline std::string csmip_channel(double factor) {
    std::string text = "CORRECTED ACCELEROGRAM\n";
    for (int line = 2; line <= 25; ++line) text += "text\n";
    text += fields(std::vector<int>(100, 0), 16, "%5d") + fields(std::vector<double>(100, 0.0), 8, "%10.3f");
    const char* lines[] = {"accel data equally spaced at  .020 sec.  (units: cm/sec/sec)",
                           "VELOC DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC)",
                           "displ data equally spaced at  .020 sec.  (units: cm)"};
    for (const char* line : lines) {
        text += std::string("   10 points of ") + line + "\n";
        if (line[0] == 'V') text.replace(text.rfind("points of"), 9, "POINTS OF");
        std::vector<double> values = ten;
        for (double& value : values) value *= factor;
        text += fields(values, 8, "%10.7f");  // nine characters and a sign: no separators
    }
    return text + "/&  ----------  End of data for channel  1  ----------\n";
}

inline std::string csmip() {
    return csmip_channel(1) + csmip_channel(-1);
}

inline std::string esm() {
    std::string text = "EVENT_NAME: Somewhere\n";
    while (std::count(text.begin(), text.end(), '\n') < 60) text += "USER: 1: 2\n";
    text += "SAMPLING_INTERVAL_S: 0.020000\nNDATA: 10\nUNITS: cm/s^2\nDATA_TYPE: ACCELERATION\n";
    return text + fields(ten, 1, "%.6f");
}

inline std::string geonet_component(bool raw) {
    std::string text = raw ? "Uncorrected accelerogram\n" : "Corrected accelerogram\n";
    for (int line = 2; line <= 16; ++line)
        text += line == 10 ? "Number of points    10    Duration 0.18 sec\n" : "text\n";
    std::vector<int> integers(40, 0);
    integers[30] = 10;
    integers[33] = integers[34] = integers[35] = raw ? 0 : 10;
    std::vector<double> reals(60, 0.0);
    reals[24] = raw ? 0.02 : 0.005;
    reals[25] = raw ? 0.0 : 0.02;
    text += fields(integers, 10, "%8d") + fields(reals, 10, "%8.4f");
    for (int block = 0; block < (raw ? 1 : 3); ++block) text += fields(ten, 10, "%8.3f");
    return text;
}

inline std::string geonet() {
    return geonet_component(false) + geonet_component(false) + geonet_component(false);
}

inline std::string smc() {
    std::string text = "2 CORRECTED ACCELEROGRAM\n";
    for (int line = 2; line <= 11; ++line) text += "*\n";
    std::vector<int> integers(48, -32768);
    integers[15] = 2;
    integers[16] = 10;
    std::vector<double> reals(50, 1.7e38);
    reals[1] = 50;
    text += fields(integers, 8, "%10d") + fields(reals, 5, "%15.7E") + "|\n|a comment\n";
    // 8(1pe10.4e1) as in the published files: "-3.0380E+0", one digit of exponent
    for (std::size_t k = 0; k < ten.size(); ++k) {
        char field[32];
        std::snprintf(field, sizeof field, "%10.4E", ten[k]);
        std::string word = field;
        word.erase(word.size() - 2, 1);
        text += std::string(10 - word.size(), ' ') + word + (k == 7 || k == 9 ? "\n" : "");
    }
    return text;
}

inline std::string sac(bool big_endian = false, std::uint32_t version = 6) {
    std::vector<std::uint32_t> words(158, std::bit_cast<std::uint32_t>(-12345.0f));
    words[0] = std::bit_cast<std::uint32_t>(0.02f);
    for (std::size_t k = 70; k < 158; ++k) words[k] = 0;
    words[76] = version;
    words[79] = 10;
    words[85] = 1;
    words[105] = 1;
    for (const double value : ten) words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    std::string bytes;
    for (const std::uint32_t word : words)
        for (int k = 0; k < 4; ++k) bytes += static_cast<char>(word >> (8 * (big_endian ? 3 - k : k)) & 255u);
    return bytes + std::string(version == 7 ? 176 : 0, '\0');
}

inline std::string csv() {
    std::string text = "time (s),acceleration (cm/s2)\n";
    for (std::size_t k = 0; k < ten.size(); ++k)
        text += std::to_string(0.02 * static_cast<double>(k)) + "," + std::to_string(ten[k]) + "\n";
    return text;
}

struct SmallRecord {
    const char* format;
    std::string text;
};

inline std::vector<SmallRecord> all() {
    return {{"peer", peer()},     {"knet", knet()}, {"cosmos", cosmos()}, {"csmip", csmip()}, {"esm", esm()},
            {"geonet", geonet()}, {"smc", smc()},   {"sac", sac()},       {"csv", csv()}};
}

}  // namespace rockslope::small_records
