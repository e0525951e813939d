#pragma once

extern "C" void __asan_init() __attribute__((weak));  // NOLINT: the name is the sanitizer's

namespace rockslope {

/// Whether the address sanitizer sees the libraries, even where the tests' own code was compiled without it.
inline bool libraries_are_sanitized() {
    return __asan_init != nullptr;
}

}  // namespace rockslope
