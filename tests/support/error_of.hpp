#pragma once

#include <string>

#include "common/base/input_error.hpp"

namespace rockslope {

/// What an InputError says; "no error" when none was thrown.
template <class Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace rockslope
