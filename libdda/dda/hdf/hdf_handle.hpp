#pragma once

#include <hdf5.h>

#include <utility>

#include "dda/hdf/library_guard.hpp"

namespace rockslope::dda {

/// An HDF5 identifier that is closed at the end of its scope.
class HdfHandle {
  public:
    using Closer = herr_t (*)(hid_t);

    /// No identifier.
    HdfHandle() = default;
    /// @param id negative: none. @param closer HDF5's function for identifiers of this kind.
    HdfHandle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
    ~HdfHandle() { reset(); }
    HdfHandle(HdfHandle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
    HdfHandle& operator=(HdfHandle&& other) noexcept {
        if (this != &other) {
            reset();
            id_ = std::exchange(other.id_, -1);
            closer_ = other.closer_;
        }
        return *this;
    }

    /// HDF5's number, negative where there is none.
    hid_t id() const { return id_; }
    explicit operator bool() const { return id_ >= 0; }
    /// Closes the identifier, unless the library has failed.
    void reset() {
        if (id_ >= 0 && !library_has_failed()) closer_(id_);
        id_ = -1;
    }

  private:
    hid_t id_ = -1;
    Closer closer_ = nullptr;
};

}  // namespace rockslope::dda
