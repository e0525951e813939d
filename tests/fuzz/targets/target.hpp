#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"

/// What libFuzzer, or replay.cpp, calls with each input. A target crashes, or throws, where its reader fails.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace rockslope::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// A file in memory with the bytes of an input. There is one for each name, of this process.
inline std::filesystem::path file_of(std::string_view bytes, const std::string& name) {
    const std::filesystem::path folder =
        std::filesystem::path("/dev/shm") / ("rockslope_fuzz_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const std::filesystem::path path = folder / name;
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path;
}

/// Removes the files of file_of().
inline void remove_files() {
    std::error_code ignored;
    std::filesystem::remove_all("/dev/shm/rockslope_fuzz_" + std::to_string(::getpid()), ignored);
}

/// Calls read(). It may refuse the input, and nothing else.
template <class Read>
int reads_or_refuses(const Read& read) {
    try {
        read();
    } catch (const InputError&) {
    } catch (const OutputError&) {  // also thrown for results that cannot be read
    }
    return 0;
}

}  // namespace rockslope::fuzz
