#include <cmath>

#include "common/base/atomic_file.hpp"
#include "common/base/output_error.hpp"
#include "common/base/text.hpp"
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

/// One frame as a VTK XML unstructured grid, in text.
std::string vtu_text(const GridFrame& frame, const std::vector<GridColumn>& columns) {
    const GridCells& cells = frame.cells;
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
        "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
        std::to_string(frame.points.size() / 3) + "\" NumberOfCells=\"" + std::to_string(cells.count()) +
        "\">\n<Points>\n";
    text += array_text("Points", "Float64", 3, frame.points) + "</Points>\n<Cells>\n";
    const std::vector<std::int64_t> ends(cells.offsets.begin() + 1, cells.offsets.end());
    text += array_text("connectivity", "Int64", 1, cells.connectivity) +
            array_text("offsets", "Int64", 1, ends) + array_text("types", "UInt8", 1, cells.types);
    text += "</Cells>\n<CellData>\n";
    for (std::size_t i = 0; i < columns.size(); ++i)
        text += array_text(columns[i].name, "Float32", columns[i].width, frame.columns[i]);
    return text + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

/// NAME.pvd, a list of files NAME.K.vtu, for viewers that cannot read temporal VTKHDF.
class Pvd : public ResultWriter {
  public:
    explicit Pvd(const WriterContext& context)
        : model_(context.model),
          folder_(context.folder),
          name_(context.name),
          cells_(block_cells(context.model)) {
        if (!context.resume_from) return;
        const VtkHdfReader blocks(folder_ / (name_ + ".vtkhdf"));
        for (std::int64_t k = 0; k < *context.resume_from; ++k) times_.push_back(blocks.times()[k]);
    }

    void frame(const State& state) override {
        const GridFrame frame = active_block_frame(model_, state, cells_);
        for (const auto& column : frame.columns)
            for (const float value : column)
                if (!std::isfinite(value))
                    throw OutputError(folder_ / (name_ + ".pvd"),
                                      "a value at t = " + shortest_text(state.time) +
                                          " s is not finite; the frame is not written");
        write_file_atomically(folder_ / frame_name(times_.size()), vtu_text(frame, block_columns()));
        times_.push_back(state.time);
        write_file_atomically(folder_ / (name_ + ".pvd"), list_text());
    }
    std::int64_t position() const override { return static_cast<std::int64_t>(times_.size()); }

  private:
    std::string frame_name(std::size_t index) const { return name_ + "." + std::to_string(index) + ".vtu"; }
    std::string list_text() const {
        std::string text =
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
        for (std::size_t k = 0; k < times_.size(); ++k)
            text +=
                "<DataSet timestep=\"" + shortest_text(times_[k]) + "\" file=\"" + frame_name(k) + "\"/>\n";
        return text + "</Collection>\n</VTKFile>\n";
    }

    const Model& model_;
    std::filesystem::path folder_;
    std::string name_;
    GridCells cells_;
    std::vector<double> times_;
};

}  // namespace

WriterEntry pvd() {
    return {"pvd", "*.pvd", PositionUnit::none, [](const WriterContext& context) { return context.pvd; },
            make_writer<Pvd>};
}

}  // namespace rockslope::dda
