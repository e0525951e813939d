#include "dda/hdf/hdf.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <utility>

#include "common/base/output_error.hpp"
#include "dda/hdf/hdf_access.hpp"
#include "dda/hdf/hdf_handle.hpp"

namespace rockslope::dda {

namespace {

hid_t file_type(HdfType type) {
    switch (type) {
        case HdfType::f4:
            return H5T_IEEE_F32LE;
        case HdfType::f8:
            return H5T_IEEE_F64LE;
        case HdfType::i8:
            return H5T_STD_I64LE;
        default:
            return H5T_STD_U8LE;
    }
}

constexpr std::size_t largest_kept_chunk = 1 << 20;

}  // namespace

hid_t memory_type(HdfType type) {
    switch (type) {
        case HdfType::f4:
            return H5T_NATIVE_FLOAT;
        case HdfType::f8:
            return H5T_NATIVE_DOUBLE;
        case HdfType::i8:
            return H5T_NATIVE_INT64;
        default:
            return H5T_NATIVE_UINT8;
    }
}

void prepare_library() {
    static std::once_flag once;
    std::call_once(once, [] {
        H5dont_atexit();  // every file is closed, and a library that has failed must not be called at the end
        ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    });
}

HdfHandle string_type(std::size_t size) {
    HdfHandle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.id(), size);
    H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
    H5Tset_cset(type.id(), H5T_CSET_ASCII);
    return type;
}

HdfFile::HdfFile(std::filesystem::path path) : path_(std::move(path)), file_(std::make_unique<Access>()) {}
HdfFile::~HdfFile() = default;
HdfFile::HdfFile(HdfFile&&) noexcept = default;
HdfFile& HdfFile::operator=(HdfFile&&) noexcept = default;

HdfFile HdfFile::create(const std::filesystem::path& path) {
    prepare_library();
    const HdfHandle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation.id(), 0);
    const HdfHandle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST);
    errno = 0;
    HdfFile file(path);
    file.file_->file =
        HdfHandle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
    file.check(file.file_->id(), "cannot be created");
    return file;
}

void HdfFile::fail(const std::string& what) const {
    throw OutputError(path_, errno != 0 ? what + ": " + std::strerror(errno) : what);
}

std::int64_t HdfFile::check(std::int64_t result, const std::string& what) const {
    if (result < 0) fail(what);
    return result;
}

void HdfFile::add_group(const std::string& name) {
    HdfHandle(
        check(H5Gcreate2(file_->id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "group " + name),
        H5Gclose);
}

void HdfFile::set_attribute(const std::string& object, const std::string& name,
                            const std::vector<std::int64_t>& values) {
    const hsize_t size = values.size();
    const HdfHandle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const HdfHandle attribute(H5Acreate_by_name(file_->id(), object.c_str(), name.c_str(), H5T_STD_I64LE,
                                                space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                              H5Aclose);
    check(attribute.id(), "attribute " + name);
    check(H5Awrite(attribute.id(), H5T_NATIVE_INT64, values.data()), "attribute " + name);
}

void HdfFile::set_attribute(const std::string& object, const std::string& name, std::int64_t value) {
    // Keep the object open: HDF5 1.10 cannot rewrite an attribute opened by name alone after a flush.
    const HdfHandle owner(check(H5Oopen(file_->id(), object.c_str(), H5P_DEFAULT), "object " + object),
                          H5Oclose);
    const bool exists = H5Aexists(owner.id(), name.c_str()) > 0;
    const HdfHandle space(H5Screate(H5S_SCALAR), H5Sclose);
    const HdfHandle attribute(
        exists ? H5Aopen(owner.id(), name.c_str(), H5P_DEFAULT)
               : H5Acreate2(owner.id(), name.c_str(), H5T_STD_I64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    check(attribute.id(), "attribute " + name);
    check(H5Awrite(attribute.id(), H5T_NATIVE_INT64, &value), "attribute " + name);
}

void HdfFile::set_attribute(const std::string& object, const std::string& name, const std::string& ascii) {
    const HdfHandle type = string_type(std::max<std::size_t>(ascii.size(), 1));
    const HdfHandle space(H5Screate(H5S_SCALAR), H5Sclose);
    const HdfHandle attribute(H5Acreate_by_name(file_->id(), object.c_str(), name.c_str(), type.id(),
                                                space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                              H5Aclose);
    check(attribute.id(), "attribute " + name);
    check(H5Awrite(attribute.id(), type.id(), ascii.c_str()), "attribute " + name);
}

void HdfFile::add_dataset(const std::string& name, HdfType type, int width, std::size_t chunk,
                          bool compressed) {
    create_dataset(name, file_type(type), width, chunk, compressed);
}

void HdfFile::create_dataset(const std::string& name, std::int64_t type, int width, std::size_t chunk,
                             bool compressed) {
    const int rank = width == 1 ? 1 : 2;
    const hsize_t size[] = {0, static_cast<hsize_t>(width)};
    const hsize_t limit[] = {H5S_UNLIMITED, static_cast<hsize_t>(width)};
    const hsize_t chunks[] = {std::max<std::size_t>(chunk, 1), static_cast<hsize_t>(width)};
    const HdfHandle space(H5Screate_simple(rank, size, limit), H5Sclose);
    const HdfHandle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation.id(), 0);
    H5Pset_chunk(creation.id(), rank, chunks);
    if (compressed) {
        H5Pset_shuffle(creation.id());
        H5Pset_deflate(creation.id(), 1);
    }
    const HdfHandle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
    // The last chunk stays in memory. A chunk larger than a megabyte is written at once.
    const std::size_t chunk_bytes = chunks[0] * static_cast<std::size_t>(width) * H5Tget_size(type);
    H5Pset_chunk_cache(access.id(), 1, std::min(chunk_bytes, largest_kept_chunk), 1.0);
    HdfHandle set(
        H5Dcreate2(file_->id(), name.c_str(), type, space.id(), H5P_DEFAULT, creation.id(), access.id()),
        H5Dclose);
    check(set.id(), "dataset " + name);
    file_->growing.emplace(name, Access::Growing{std::move(set), 0, static_cast<hsize_t>(width)});
}

void HdfFile::append_bytes(const std::string& name, HdfType type, const void* data,
                           std::size_t element_count) {
    append_values(name, memory_type(type), data, element_count);
}

void HdfFile::add_text_dataset(const std::string& name) {
    const HdfHandle type = string_type(H5T_VARIABLE);
    create_dataset(name, type.id(), 1, 64, false);
}

void HdfFile::append_text(const std::string& name, const std::string& text) {
    const HdfHandle type = string_type(H5T_VARIABLE);
    const char* const data = text.c_str();
    append_values(name, type.id(), &data, 1);
}

void HdfFile::append_values(const std::string& name, std::int64_t memory_type, const void* data,
                            std::size_t element_count) {
    Access::Growing& dataset = file_->growing.at(name);
    const hid_t set = dataset.set.id();
    const hsize_t start[] = {dataset.rows, 0};
    const hsize_t count[] = {element_count / dataset.width, dataset.width};
    const hsize_t size[] = {start[0] + count[0], dataset.width};
    if (count[0] == 0) return;
    const int rank = dataset.width == 1 ? 1 : 2;
    errno = 0;
    check(H5Dset_extent(set, size), "cannot be written");
    const HdfHandle space(H5Dget_space(set), H5Sclose);
    H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr);
    const HdfHandle memory(H5Screate_simple(rank, count, nullptr), H5Sclose);
    check(H5Dwrite(set, memory_type, memory.id(), space.id(), H5P_DEFAULT, data), "cannot be written");
    dataset.rows = size[0];
}

int HdfFile::descriptor() const {
    void* handle = nullptr;
    check(H5Fget_vfd_handle(file_->id(), H5P_DEFAULT, &handle), "cannot be written");
    return *static_cast<int*>(handle);
}

void HdfFile::reserve(std::size_t bytes) const {
    const int descriptor = this->descriptor();
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) fail("cannot be written");
    const off_t end = status.st_size;
    const int result = ::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, end, static_cast<off_t>(bytes));
    int reason = result == 0 || errno == EOPNOTSUPP || errno == ENOSYS ? 0 : errno;
    // fallocate does not check the file size limit for room beyond the end of the file.
    rlimit limit{};
    if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
        static_cast<std::size_t>(end) + bytes > limit.rlim_cur)
        reason = EFBIG;
    errno = reason;
    if (reason != 0) fail("cannot be written");
}

void HdfFile::flush() {
    errno = 0;
    check(H5Fflush(file_->id(), H5F_SCOPE_GLOBAL), "cannot be written");
}

void HdfFile::sync() const {
    errno = 0;
    if (::fsync(descriptor()) != 0 && errno != EINVAL && errno != ENOTSUP) fail("cannot be written");
}

}  // namespace rockslope::dda
