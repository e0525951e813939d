#include <functional>
#include <memory>

#include "common/base/atomic_file.hpp"
#include "dda/hdf/vtkhdf_file.hpp"
#include "dda/writers/frame_data.hpp"
#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

namespace {

using FrameOf = std::function<GridFrame(const Model&, const State&)>;
using MakeFile = std::function<VtkHdfFile(const std::filesystem::path&)>;

/// The file of a resumed run, a copy of the old one. The frames up to the checkpoint are written again by the
/// same calls, so that the bytes are those of an uninterrupted run.
VtkHdfFile resumed_file(const std::filesystem::path& path, const std::filesystem::path& copy,
                        const MakeFile& make, const GridLayout& layout, std::int64_t frames) {
    VtkHdfFile file = make(copy);
    file.show_as(path);
    const VtkHdfReader old(path);
    for (std::int64_t k = 0; k < frames; ++k)
        file.append(old.frame(k, names_of(layout.columns), names_of(layout.point_columns)));
    return file;
}

/// A resumed run leaves the file that it finds, which may hold frames from after the checkpoint, until it has
/// written as many itself.
class FrameWriter : public ResultWriter {
  public:
    FrameWriter(const WriterContext& context, const std::string& extension, const GridLayout& layout,
                const MakeFile& make, FrameOf frame_of)
        : model_(context.model),
          frame_of_(std::move(frame_of)),
          path_(context.folder / (context.name + extension)),
          old_frames_(context.resume_from ? VtkHdfReader(path_).frame_count() : 0),
          copy_(context.resume_from ? std::make_unique<PendingFile>(path_) : nullptr),
          file_(copy_ ? resumed_file(path_, copy_->temporary(), make, layout, *context.resume_from)
                      : make(path_)) {
        if (file_.frame_count() >= old_frames_) cut();
    }

    void frame(const State& state, const Stage& stage) override {
        GridFrame frame = frame_of_(model_, state);
        frame.stage = stage.name;
        file_.append(frame);
        if (file_.frame_count() >= old_frames_) cut();
    }
    void cut() override {
        if (copy_) copy_->put_in_place();
        copy_.reset();
    }
    /// A checkpoint of a resumed run counts on the frames that were found, and a kill had left in memory.
    void sync() override {
        if (copy_) sync_file(path_);
        file_.sync();
    }
    std::int64_t position() const override { return file_.frame_count(); }
    std::string digest() const override { return file_.digest(); }

  private:
    const Model& model_;
    FrameOf frame_of_;
    std::filesystem::path path_;
    std::int64_t old_frames_;            ///< in the file that a resumed run found
    std::unique_ptr<PendingFile> copy_;  ///< the file, as long as it is beside the one that was found
    VtkHdfFile file_;
};

/// Frames of a run with excavations: each has the cells of its blocks.
std::unique_ptr<ResultWriter> make_excavated_block_frames(const WriterContext& context) {
    const GridLayout layout = block_layout(context.model);
    const MakeFile make = [&](const std::filesystem::path& path) {
        return VtkHdfFile(path, layout, context.model.block_material.size());
    };
    return std::make_unique<FrameWriter>(
        context, ".vtkhdf", layout, make,
        [cells = block_cells(context.model)](const Model& model, const State& state) {
            return active_block_frame(model, state, cells);
        });
}

std::unique_ptr<ResultWriter> make_block_frames(const WriterContext& context) {
    if (!context.model.excavations.empty()) return make_excavated_block_frames(context);
    const GridLayout layout = block_layout(context.model);
    const MakeFile make = [&](const std::filesystem::path& path) {
        return VtkHdfFile(path, layout, block_cells(context.model), context.model.vertices.size());
    };
    return std::make_unique<FrameWriter>(context, ".vtkhdf", layout, make, block_frame);
}

std::unique_ptr<ResultWriter> make_joint_frames(const WriterContext& context) {
    const GridLayout layout = contact_layout(context.model);
    const MakeFile make = [&](const std::filesystem::path& path) {
        // A block of a jointed mass touches about three neighbours per block, with two contacts per joint.
        return VtkHdfFile(path, layout, 6 * context.model.block_material.size() + 64);
    };
    return std::make_unique<FrameWriter>(context, ".joints.vtkhdf", layout, make, contact_frame);
}

}  // namespace

WriterEntry block_frames() {
    return {"blocks", "*.vtkhdf", PositionUnit::frames, is_always_written, make_block_frames};
}

WriterEntry joint_frames() {
    return {"joints", "*.joints.vtkhdf", PositionUnit::frames,
            [](const WriterContext& context) { return context.joint_frames; }, make_joint_frames};
}

}  // namespace rockslope::dda
