#include <algorithm>
#include <utility>

#include "dda/hdf/hdf_access.hpp"

namespace rockslope::dda {

namespace {

/// A declared size, bytes, is believed up to so many times what is stored: deflated zeros take a thousandth.
constexpr double largest_deflation = 1100;
/// Bytes of one chunk, which may be stored as nothing where it is all zeros.
constexpr double least_believed = 1 << 24;

}  // namespace

HdfFile HdfFile::open_to_read(const std::filesystem::path& path) {
    prepare_library();
    errno = 0;
    HdfFile file(path);
    file.file_->file =
        HdfHandle(file.guarded([&] { return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT); }), H5Fclose);
    file.check(file.file_->id(), "cannot be read as HDF5");
    return file;
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

}  // namespace rockslope::dda
