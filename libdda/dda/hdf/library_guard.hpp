#pragma once

namespace rockslope::dda {

/// Processor time of a call that reads, s, after which it will not end: by then it could have inflated a
/// gigabyte.
inline constexpr double longest_call = 10;

/// Runs `call(data)`, a call of the HDF5 library that reads. @return false where the library fails on damaged
/// bytes by a division by zero or a bad address, which would end the program, or goes round for `seconds` of
/// processor time. The library may not be called again then.
bool survives(void (*call)(void*), void* data, double seconds = longest_call);

/// Whether a call has failed in that way.
bool library_has_failed();

}  // namespace rockslope::dda
