#include "dda/hdf/frame_digest.hpp"

#include <map>
#include <string_view>

namespace rockslope::dda {

namespace {

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace

std::string FrameDigest::of_cells(const GridCells& cells) {
    Sha256 sum;
    sum.add(bytes_of(cells.connectivity));
    sum.add(bytes_of(cells.offsets));
    sum.add(bytes_of(cells.types));
    return sum.digest();
}

/// The columns by their names, for a file lists them so.
void FrameDigest::add_columns(const std::vector<std::vector<float>>& columns,
                              const std::vector<std::string>& names) {
    std::map<std::string, std::string_view> by_name;
    for (std::size_t k = 0; k < names.size(); ++k) by_name[names[k]] = bytes_of(columns[k]);
    for (const auto& [name, bytes] : by_name) {
        sum_.add(name + "\n");
        sum_.add(bytes);
    }
}

void FrameDigest::add(const GridFrame& frame, const std::vector<std::string>& columns,
                      const std::vector<std::string>& point_columns, const std::string& cells) {
    sum_.add({reinterpret_cast<const char*>(&frame.time), sizeof frame.time});
    sum_.add(frame.stage + "\n" + cells);
    sum_.add(bytes_of(frame.points));
    add_columns(frame.columns, columns);
    add_columns(frame.point_columns, point_columns);
}

}  // namespace rockslope::dda
