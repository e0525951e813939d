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
#include <unordered_map>
#include <utility>

#include "common/base/output_error.hpp"
#include "dda/hdf/hdf_handle.hpp"
#include "dda/hdf/library_guard.hpp"

namespace rockslope::dda {

namespace {

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

/// Switches off HDF5's error printing and file locking.
void prepare_library() {
    static std::once_flag once;
    std::call_once(once, [] {
        H5dont_atexit();  // every file is closed, and a library that has failed must not be called at the end
        ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    });
}

/// A declared size, bytes, is believed up to so many times what is stored: deflated zeros take a thousandth.
constexpr double largest_deflation = 1100;
/// Bytes of one chunk, which may be stored as nothing where it is all zeros.
constexpr double least_believed = 1 << 24;

constexpr std::size_t largest_kept_chunk = 1 << 20;

/// @param size bytes, or H5T_VARIABLE.
HdfHandle string_type(std::size_t size) {
    HdfHandle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.id(), size);
    H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
    H5Tset_cset(type.id(), H5T_CSET_ASCII);
    return type;
}

}  // namespace

struct HdfFile::Access {
    /// A dataset that grows. It stays open as long as the file: to open and close it takes longer than to
    /// write a frame's rows.
    struct Growing {
        HdfHandle set;
        hsize_t rows, width;
    };

    HdfHandle file;
    std::unordered_map<std::string, Growing> growing;  ///< by its name

    hid_t id() const { return file.id(); }
    /// Handle of a dataset in a file of unknown origin.
    HdfHandle dataset_of(const HdfFile& owner, const std::string& name) const {
        HdfHandle set(owner.guarded([&] { return H5Dopen2(id(), name.c_str(), H5P_DEFAULT); }), H5Dclose);
        owner.check(set.id(), "has no dataset " + name);
        return set;
    }
};

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

HdfFile HdfFile::open_to_read(const std::filesystem::path& path) {
    prepare_library();
    errno = 0;
    HdfFile file(path);
    file.file_->file =
        HdfHandle(file.guarded([&] { return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT); }), H5Fclose);
    file.check(file.file_->id(), "cannot be read as HDF5");
    return file;
}

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

bool HdfFile::has_attribute(const std::string& object, const std::string& name) const {
    return guarded(
               [&] { return H5Aexists_by_name(file_->id(), object.c_str(), name.c_str(), H5P_DEFAULT); }) > 0;
}

std::int64_t HdfFile::open_attribute(const std::string& object, const std::string& name) const {
    return check(guarded([&] {
                     return H5Aopen_by_name(file_->id(), object.c_str(), name.c_str(), H5P_DEFAULT,
                                            H5P_DEFAULT);
                 }),
                 "has no attribute " + name);
}

std::int64_t HdfFile::integer_attribute(const std::string& object, const std::string& name) const {
    const HdfHandle attribute(open_attribute(object, name), H5Aclose);
    const HdfHandle space(H5Aget_space(attribute.id()), H5Sclose);
    if (H5Sget_simple_extent_npoints(space.id()) != 1) fail("attribute " + name + " is not one number");
    check_number("attribute " + name, H5Aget_type(attribute.id()));
    std::int64_t value = 0;
    check(guarded([&] { return H5Aread(attribute.id(), H5T_NATIVE_INT64, &value); }), "attribute " + name);
    return value;
}

std::string HdfFile::string_attribute(const std::string& object, const std::string& name) const {
    const HdfHandle attribute(open_attribute(object, name), H5Aclose);
    const HdfHandle space(H5Aget_space(attribute.id()), H5Sclose);
    if (H5Sget_simple_extent_npoints(space.id()) != 1) fail("attribute " + name + " is not one text");
    const HdfHandle type(H5Aget_type(attribute.id()), H5Tclose);
    constexpr std::size_t longest_text_bytes = 1 << 16;
    if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0 ||
        H5Tget_size(type.id()) > longest_text_bytes)
        fail("attribute " + name + " is not a fixed-length string of at most 65536 bytes");
    std::string text(H5Tget_size(type.id()), '\0');
    check(guarded([&] { return H5Aread(attribute.id(), type.id(), text.data()); }), "attribute " + name);
    return text;
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

bool HdfFile::has(const std::string& name) const {
    return guarded([&] { return H5Lexists(file_->id(), name.c_str(), H5P_DEFAULT); }) > 0;
}

std::pair<std::size_t, std::size_t> HdfFile::shape_of(const std::string& name) const {
    const HdfHandle set = file_->dataset_of(*this, name);
    const HdfHandle space(H5Dget_space(set.id()), H5Sclose);
    hsize_t size[2] = {0, 1};
    const int rank = H5Sget_simple_extent_ndims(space.id());
    if (rank < 1 || rank > 2) fail("dataset " + name + " does not have one or two dimensions");
    check(H5Sget_simple_extent_dims(space.id(), size, nullptr), "dataset " + name);
    if (size[1] < 1) fail("dataset " + name + " has no columns");
    return {size[0], size[1]};
}

void HdfFile::check_rows(const std::string& name, std::size_t first, std::size_t count) const {
    const std::size_t rows = row_count(name);
    if (first > rows || count > rows - first) fail("dataset " + name + " ends early");
}

void HdfFile::check_size(const std::string& name, double bytes) const {
    if (bytes <= least_believed) return;
    const HdfHandle set = file_->dataset_of(*this, name);
    std::uint64_t stored = 0;
    guarded([&] {
        stored = H5Dget_storage_size(set.id());
        return 0;
    });
    errno = 0;
    if (bytes > largest_deflation * static_cast<double>(stored))
        fail("dataset " + name + " declares more than it holds");
}

/// The library converts through a buffer of at least one stored number, 2 GB in a damaged file.
void HdfFile::check_number(const std::string& what, std::int64_t stored_type) const {
    constexpr std::size_t largest_number_bytes = 8;
    const HdfHandle type(stored_type, H5Tclose);
    const H5T_class_t kind = H5Tget_class(type.id());
    errno = 0;
    if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || H5Tget_size(type.id()) > largest_number_bytes)
        fail(what + " does not hold numbers of at most 8 bytes");
}

void HdfFile::has_no_memory(const std::string& name) const {
    errno = 0;
    fail("dataset " + name + " takes more memory than there is");
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

/// The library allocates what a text says that it has, 4 GB in a damaged file, before it looks for the bytes.
/// A row of a chunk has the length, 4 bytes, and 12 of where the text is.
void HdfFile::check_texts(const std::string& name, std::int64_t set) const {
    constexpr std::size_t row_bytes = 16;
    errno = 0;
    const auto declares_too_much = [&] { fail("dataset " + name + " declares longer texts than it holds"); };
    hsize_t file_size = 0, chunk = 0;
    check(H5Fget_filesize(file_->id(), &file_size), "cannot be read");
    const HdfHandle creation(H5Dget_create_plist(set), H5Pclose);
    if (H5Pget_layout(creation.id()) != H5D_CHUNKED || H5Pget_chunk(creation.id(), 1, &chunk) != 1 ||
        chunk < 1 || H5Pget_nfilters(creation.id()) != 0)
        fail("dataset " + name + " does not hold texts as dda-run writes them");
    hsize_t declared = 0;
    for (hsize_t first = 0; first < row_count(name); first += chunk) {
        hsize_t stored = 0;
        check(guarded([&] { return H5Dget_chunk_storage_size(set, &first, &stored); }), "dataset " + name);
        if (stored > file_size) declares_too_much();
        std::vector<unsigned char> rows(stored);
        std::uint32_t filters = 0;
        if (stored > 0)
            check(guarded([&] { return H5Dread_chunk(set, H5P_DEFAULT, &first, &filters, rows.data()); }),
                  "dataset " + name + " cannot be read");
        for (std::size_t at = 0; at + row_bytes <= rows.size(); at += row_bytes)
            for (std::size_t byte = 0; byte < 4; ++byte) declared += hsize_t{rows[at + byte]} << 8 * byte;
    }
    if (declared > file_size) declares_too_much();
}

std::vector<std::string> HdfFile::read_texts(const std::string& name) const {
    const HdfHandle set = file_->dataset_of(*this, name);
    const HdfHandle stored(H5Dget_type(set.id()), H5Tclose);
    if (H5Tis_variable_str(stored.id()) <= 0) fail("dataset " + name + " does not hold texts");
    const HdfHandle type = string_type(H5T_VARIABLE);
    check_size(name, static_cast<double>(row_count(name)) * sizeof(char*));
    check_texts(name, set.id());
    std::vector<char*> data(row_count(name));
    errno = 0;
    check(guarded([&] { return H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()); }),
          "dataset " + name + " cannot be read");
    std::vector<std::string> texts;
    for (char* text : data) {
        texts.emplace_back(text != nullptr ? text : "");
        H5free_memory(text);
    }
    return texts;
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

void HdfFile::read_bytes(const std::string& name, HdfType type, std::size_t first, std::size_t count,
                         void* data) const {
    if (count == 0) return;
    const HdfHandle set = file_->dataset_of(*this, name);
    check_number("dataset " + name, H5Dget_type(set.id()));
    const hsize_t width = width_of(name);
    const hsize_t start[] = {first, 0};
    const hsize_t counts[] = {count, width};
    const HdfHandle space(H5Dget_space(set.id()), H5Sclose);
    errno = 0;
    check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, counts, nullptr),
          "dataset " + name);
    const HdfHandle memory(H5Screate_simple(width == 1 ? 1 : 2, counts, nullptr), H5Sclose);
    check(guarded([&] {
              return H5Dread(set.id(), memory_type(type), memory.id(), space.id(), H5P_DEFAULT, data);
          }),
          "dataset " + name + " cannot be read");
}

std::vector<std::string> HdfFile::names_in(const std::string& group) const {
    std::vector<std::string> names;
    const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
        static_cast<std::vector<std::string>*>(out)->emplace_back(name);
        return 0;
    };
    errno = 0;
    check(guarded([&] {
              return H5Literate_by_name(file_->id(), group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr,
                                        collect, &names, H5P_DEFAULT);
          }),
          "has no group " + group);
    return names;
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
