#pragma once

#include <gtest/gtest.h>

#include <string>

namespace rockslope {

/// A text with the first `from`, which it must contain, replaced by `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace rockslope
