#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace rockslope::dda {

/// Element types of datasets: float, double, 64-bit integer, byte.
enum class HdfType { f4, f8, i8, u1 };

/// The type of the file for elements of type T.
template <class T>
constexpr HdfType hdf_type_of();
template <>
constexpr HdfType hdf_type_of<float>() {
    return HdfType::f4;
}
template <>
constexpr HdfType hdf_type_of<double>() {
    return HdfType::f8;
}
template <>
constexpr HdfType hdf_type_of<std::int64_t>() {
    return HdfType::i8;
}
template <>
constexpr HdfType hdf_type_of<std::uint8_t>() {
    return HdfType::u1;
}

/// An HDF5 file of datasets that grow by rows. File locking is off: a viewer may read the file of a running
/// analysis. No times are stored: equal writes give equal bytes. Every failure to write or read throws an
/// OutputError that names the file.
class HdfFile {
  public:
    /// A new, empty file.
    static HdfFile create(const std::filesystem::path& path);
    /// An existing file, which must be of HDF5.
    static HdfFile open_to_read(const std::filesystem::path& path);
    ~HdfFile();
    HdfFile(HdfFile&&) noexcept;
    HdfFile& operator=(HdfFile&&) noexcept;

    /// The path that messages name, by which the file was opened.
    const std::filesystem::path& path() const { return path_; }

    void add_group(const std::string& name);
    void set_attribute(const std::string& object, const std::string& name,
                       const std::vector<std::int64_t>& values);
    void set_attribute(const std::string& object, const std::string& name, std::int64_t value);
    void set_attribute(const std::string& object, const std::string& name, const std::string& ascii);
    /// Whether an object of the file has the attribute.
    bool has_attribute(const std::string& object, const std::string& name) const;
    std::int64_t integer_attribute(const std::string& object, const std::string& name) const;
    std::string string_attribute(const std::string& object, const std::string& name) const;

    /// Adds an empty dataset with rows of `width` elements (1: one-dimensional). HDF5 stores `chunk` rows
    /// together, deflated if `compressed`. Rows can be appended through this object only.
    void add_dataset(const std::string& name, HdfType type, int width, std::size_t chunk, bool compressed);
    /// Whether the file has an object of this name.
    bool has(const std::string& name) const;
    /// Number of rows of a dataset.
    std::size_t row_count(const std::string& name) const { return shape_of(name).first; }

    /// Adds rows at the end of a dataset. @param values row after row.
    template <class T>
    void append(const std::string& name, const std::vector<T>& values) {
        append_bytes(name, hdf_type_of<T>(), values.data(), values.size());
    }
    /// Rows [first, first + count) of a dataset, row after row.
    template <class T>
    std::vector<T> read(const std::string& name, std::size_t first, std::size_t count) const {
        check_rows(name, first, count);
        const std::size_t width = width_of(name);
        check_size(name, static_cast<double>(count) * static_cast<double>(width) * sizeof(T));
        std::vector<T> values;
        try {
            values.resize(count * width);
        } catch (const std::bad_alloc&) {
            has_no_memory(name);
        }
        read_bytes(name, hdf_type_of<T>(), first, count, values.data());
        return values;
    }
    /// All rows of a dataset, one after the other.
    template <class T>
    std::vector<T> read_all(const std::string& name) const {
        return read<T>(name, 0, row_count(name));
    }
    /// Adds an empty one-dimensional dataset of texts of any length.
    void add_text_dataset(const std::string& name);
    /// Adds a text at the end of such a dataset.
    void append_text(const std::string& name, const std::string& text);
    /// All texts of such a dataset.
    std::vector<std::string> read_texts(const std::string& name) const;

    std::vector<std::string> names_in(const std::string& group) const;

    /// Reserves disk space for this many bytes beyond the end of the file. @throws OutputError without room.
    void reserve(std::size_t bytes) const;
    /// Gives all rows and attributes to the system, which a kill of this program does not reach.
    void flush();
    /// Waits until what was flushed is on the disk.
    void sync() const;
    /// Sets the path that messages name, for a file that will be renamed.
    void show_as(const std::filesystem::path& path) { path_ = path; }

  private:
    struct Access;  // keeps hdf5.h out of this header
    explicit HdfFile(std::filesystem::path path);

    [[noreturn]] void fail(const std::string& what) const;
    /// The result of a call that reads. @throws OutputError where the library fails on damaged bytes.
    template <class Call>
    std::int64_t guarded(const Call& call) const;
    /// @throws OutputError when so many bytes cannot be in what the file stores of a dataset.
    void check_size(const std::string& name, double bytes) const;
    void check_texts(const std::string& name, std::int64_t set) const;
    /// @throws OutputError when a type as the file stores it is no number that dda-run writes.
    void check_number(const std::string& what, std::int64_t stored_type) const;
    [[noreturn]] void has_no_memory(const std::string& name) const;
    /// HDF5's identifier of an attribute.
    std::int64_t open_attribute(const std::string& object, const std::string& name) const;
    /// Returns an HDF5 result. @throws OutputError if it is negative, which means failure.
    std::int64_t check(std::int64_t result, const std::string& what) const;
    /// Rows and width of a dataset.
    std::pair<std::size_t, std::size_t> shape_of(const std::string& name) const;
    std::size_t width_of(const std::string& name) const { return shape_of(name).second; }
    /// @throws OutputError unless the dataset has these rows: offsets of a damaged file may point past its
    /// end.
    void check_rows(const std::string& name, std::size_t first, std::size_t count) const;
    /// The same as add_dataset() and append_bytes() for any type, given by HDF5's identifier.
    void create_dataset(const std::string& name, std::int64_t type, int width, std::size_t chunk,
                        bool compressed);
    void append_values(const std::string& name, std::int64_t memory_type, const void* data,
                       std::size_t element_count);
    void append_bytes(const std::string& name, HdfType type, const void* data, std::size_t element_count);
    void read_bytes(const std::string& name, HdfType type, std::size_t first, std::size_t count,
                    void* data) const;
    /// The system's number of the open file.
    int descriptor() const;

    std::filesystem::path path_;
    std::unique_ptr<Access> file_;
};

}  // namespace rockslope::dda
