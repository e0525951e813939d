#pragma once

namespace rockslope::dda {

/// Runs `call(data)`, a call of the HDF5 library that reads. @return false where the library fails on damaged
/// bytes by a division by zero or a bad address, which would end the program. The library may not be called
/// again then.
bool survives(void (*call)(void*), void* data);

/// Whether a call has failed in that way.
bool library_has_failed();

}  // namespace rockslope::dda
