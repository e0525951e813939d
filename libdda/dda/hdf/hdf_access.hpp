#pragma once

#include <hdf5.h>

#include <cerrno>
#include <string>
#include <unordered_map>

#include "dda/hdf/hdf.hpp"
#include "dda/hdf/hdf_handle.hpp"
#include "dda/hdf/library_guard.hpp"

/// What reading and writing of an HdfFile share.
namespace rockslope::dda {

struct HdfFile::Access {
    /// A dataset that grows. It stays open as long as the file: to open and close it takes longer than to
    /// write a frame's rows.
    struct Growing {
        HdfHandle set;
        hsize_t rows, width;
    };

    HdfHandle file;
    std::unordered_map<std::string, Growing> growing;  ///< by its name

    /// HDF5's identifier of the file.
    hid_t id() const { return file.id(); }
    /// Handle of a dataset in a file of unknown origin.
    HdfHandle dataset_of(const HdfFile& owner, const std::string& name) const {
        HdfHandle set(owner.guarded([&] { return H5Dopen2(id(), name.c_str(), H5P_DEFAULT); }), H5Dclose);
        owner.check(set.id(), "has no dataset " + name);
        return set;
    }
};

/// The value of the call. @throws OutputError where the library fails, or has failed before.
template <class Call>
std::int64_t HdfFile::guarded(const Call& call) const {
    struct Result {
        const Call& call;
        std::int64_t value;
    } result{call, -1};
    if (library_has_failed() || !survives(
                                    [](void* data) {
                                        auto* const made = static_cast<Result*>(data);
                                        made->value = made->call();
                                    },
                                    &result)) {
        errno = 0;
        fail("cannot be read as HDF5: it is damaged, and the library fails on it");
    }
    return result.value;
}

/// HDF5's type of an element in memory.
hid_t memory_type(HdfType type);

/// Switches off HDF5's error printing and file locking.
void prepare_library();

/// @param size bytes, or H5T_VARIABLE.
HdfHandle string_type(std::size_t size);

}  // namespace rockslope::dda
