#include "warnings.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>

namespace rockslope {

void Warnings::tell(const char* format, ...) {
    std::array<char, 2048> line{};
    std::va_list values;
    va_start(values, format);
    std::vsnprintf(line.data(), line.size(), format, values);
    va_end(values);
    std::fprintf(stderr, "dda-run: %s\n", line.data());
    lines_.emplace_back(line.data());
}

}  // namespace rockslope
