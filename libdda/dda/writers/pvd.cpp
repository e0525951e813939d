#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>

#include "common/base/atomic_file.hpp"
#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/sha256.hpp"
#include "common/base/text.hpp"
#include "dda/hdf/vtkhdf_file.hpp"
#include "dda/writers/frame_data.hpp"
#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

namespace {

template <class T>
std::string array_text(const std::string& name, const std::string& type, int width,
                       const std::vector<T>& values) {
    std::string text = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                       std::to_string(width) + "\" format=\"ascii\">\n";
    for (const T value : values) text += shortest_text(static_cast<double>(value)) + " ";
    return text + "\n</DataArray>\n";
}

std::string texts_of(const std::vector<GridText>& texts, const std::string& stage) {
    std::string result = "<FieldData>\n";
    const auto add = [&](const std::string& name, const std::string& text) {
        result += "<Array type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"1\" format=\"ascii\">\n";
        for (const char c : text) result += std::to_string(static_cast<unsigned char>(c)) + " ";
        result += "0\n</Array>\n";
    };
    for (const GridText& text : texts) add(text.name, text.text);
    add("stage", stage);
    return result + "</FieldData>\n";
}

std::string columns_text(const std::vector<GridColumn>& columns,
                         const std::vector<std::vector<float>>& values) {
    std::string text;
    for (std::size_t i = 0; i < columns.size(); ++i)
        text += array_text(columns[i].name, "Float32", columns[i].width, values[i]);
    return text;
}

/// One frame as a VTK XML unstructured grid, in text.
std::string vtu_text(const GridFrame& frame, const GridLayout& layout) {
    const GridCells& cells = frame.cells;
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
        "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n" +
        texts_of(layout.texts, frame.stage) + "<Piece NumberOfPoints=\"" +
        std::to_string(frame.points.size() / 3) + "\" NumberOfCells=\"" + std::to_string(cells.count()) +
        "\">\n<Points>\n";
    text += array_text("Points", "Float64", 3, frame.points) + "</Points>\n<Cells>\n";
    const std::vector<std::int64_t> ends(cells.offsets.begin() + 1, cells.offsets.end());
    text += array_text("connectivity", "Int64", 1, cells.connectivity) +
            array_text("offsets", "Int64", 1, ends) + array_text("types", "UInt8", 1, cells.types);
    text += "</Cells>\n<CellData>\n" + columns_text(layout.columns, frame.columns) +
            "</CellData>\n<PointData>\n" + columns_text(layout.point_columns, frame.point_columns) +
            "</PointData>\n";
    return text + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

/// The lines of a list that are frames; none where there is no list.
std::vector<std::string> entries_of(const std::filesystem::path& list) {
    std::ifstream file(list);
    std::vector<std::string> entries;
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("<DataSet ")) entries.push_back(line);
    return entries;
}

/// STEM.pvd, a list of files STEM.K.vtu, for viewers that cannot read temporal VTKHDF.
class Pvd : public ResultWriter {
  public:
    using FrameOf = std::function<GridFrame(const State&)>;

    Pvd(const WriterContext& context, std::string stem, GridLayout layout, FrameOf frame_of)
        : folder_(context.folder),
          stem_(std::move(stem)),
          layout_(std::move(layout)),
          frame_of_(std::move(frame_of)) {
        if (!context.resume_from) return;
        const VtkHdfReader frames(folder_ / (stem_ + ".vtkhdf"));
        const auto count = static_cast<std::size_t>(*context.resume_from);
        for (std::size_t k = 0; k < count; ++k) {
            written_.add(read_text_file(folder_ / frame_file_name(stem_, position())));
            entries_.push_back(entry(frames.times()[k]));
        }
        later_ = entries_of(list());
        later_.erase(later_.begin(), later_.begin() + std::min(count, later_.size()));
    }

    void frame(const State& state, const Stage& stage) override {
        GridFrame frame = frame_of_(state);
        frame.stage = stage.name;
        for (const auto& columns : {frame.columns, frame.point_columns})
            for (const auto& column : columns)
                for (const float value : column)
                    if (!std::isfinite(value))
                        throw OutputError(folder_ / (stem_ + ".pvd"),
                                          "a value at t = " + shortest_text(state.time) +
                                              " s is not finite; the frame is not written");
        const std::string text = vtu_text(frame, layout_);
        write_file_atomically(folder_ / frame_file_name(stem_, position()), text);
        written_.add(text);
        add(entry(state.time));
        write_file_atomically(list(), list_text());
    }
    void cut() override {
        if (later_.empty()) return;
        later_.clear();
        write_file_atomically(list(), list_text());
    }
    std::int64_t position() const override { return static_cast<std::int64_t>(entries_.size()); }
    std::string digest() const override { return written_.digest(); }

  private:
    std::filesystem::path list() const { return folder_ / (stem_ + ".pvd"); }
    /// The line of the next frame.
    std::string entry(double time) const {
        return "<DataSet timestep=\"" + shortest_text(time) + "\" file=\"" +
               frame_file_name(stem_, position()) + "\"/>";
    }
    /// Adds the line of a frame. The later ones stay as long as they follow the same frames.
    void add(const std::string& line) {
        if (!later_.empty() && later_.front() == line)
            later_.erase(later_.begin());
        else
            later_.clear();
        entries_.push_back(line);
    }
    std::string list_text() const {
        std::string text =
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
        for (const auto& lines : {entries_, later_})
            for (const std::string& line : lines) text += line + "\n";
        return text + "</Collection>\n</VTKFile>\n";
    }

    std::filesystem::path folder_;
    std::string stem_;
    GridLayout layout_;
    FrameOf frame_of_;
    Sha256 written_;  ///< of the frames
    std::vector<std::string> entries_;
    std::vector<std::string> later_;  ///< of frames that a killed run wrote after its checkpoint
};

}  // namespace

std::string frame_file_name(const std::string& stem, std::int64_t index) {
    return stem + "." + std::to_string(index) + ".vtu";
}

namespace {

bool is_asked_for(const WriterContext& context) {
    return context.pvd;
}

std::unique_ptr<ResultWriter> make_block_pvd(const WriterContext& context) {
    return std::make_unique<Pvd>(context, context.name, block_layout(context.model),
                                 [&model = context.model, cells = block_cells(context.model)](
                                     const State& state) { return active_block_frame(model, state, cells); });
}

std::unique_ptr<ResultWriter> make_joint_pvd(const WriterContext& context) {
    return std::make_unique<Pvd>(
        context, context.name + ".joints", contact_layout(context.model),
        [&model = context.model](const State& state) { return contact_frame(model, state); });
}

}  // namespace

WriterEntry pvd() {
    return {"pvd", "*.pvd", PositionUnit::files, is_asked_for, make_block_pvd};
}

WriterEntry joints_pvd() {
    return {"joints_pvd", "*.joints.pvd", PositionUnit::files,
            [](const WriterContext& context) { return context.pvd && context.joint_frames; }, make_joint_pvd};
}

}  // namespace rockslope::dda
