#pragma once

#include <string>

#include "blockgen/base/input_error.hpp"

/// What an InputError says; "no error" when none was thrown.
template <class Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const blockgen::InputError& error) {
        return error.what();
    }
    return "no error";
}
