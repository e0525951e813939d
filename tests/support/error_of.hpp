#pragma once

#include <string>

#include "common/base/input_error.hpp"

namespace rockslope {

/// The text of the error that an action throws; "no error" if it throws none.
template <class Error = InputError, class Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace rockslope
