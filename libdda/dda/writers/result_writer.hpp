#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dda/analysis/state.hpp"
#include "dda/analysis/step_report.hpp"
#include "dda/model/model.hpp"
#include "dda/model/output_spec.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// Input of every writer. `model` must outlive the writer.
struct WriterContext {
    const Model& model;
    std::filesystem::path folder;
    std::string name;                         ///< stem of the result files
    std::optional<std::int64_t> resume_from;  ///< position() in the checkpoint; absent in a new run
    bool pvd = false;
    std::string relative_to = {};  ///< name of a tracked point; empty: none
    bool joint_frames = true;
    bool step_log = true;
};

/// The context of the writers of a new run.
inline WriterContext writer_context(const Model& model, const std::filesystem::path& folder,
                                    const OutputSpec& output, bool pvd) {
    return {model,          folder, output.name, std::nullopt, pvd, output.relative_to, output.joint_frames,
            output.step_log};
}

/// Writes one kind of result file. A writer overrides the events that it needs; each call leaves its file
/// complete on disk. @throws OutputError that names the file if the disk is full or a value is not finite.
class ResultWriter {
  public:
    virtual ~ResultWriter() = default;
    /// Writes a frame.
    virtual void frame(const State&, const Stage&) {}
    /// Writes a row of the histories of measured points.
    virtual void history(const State&, const Stage&) {}
    /// Records an accepted step.
    virtual void step(const State&, const Stage&, const StepReport&) {}
    /// Removes what the files that a resumed run found have beyond that which is written by now.
    virtual void cut() {}
    /// Waits until what is written so far is on the disk, where a power cut does not reach it.
    virtual void sync() {}
    /// The digest of that which is written so far, by which a run is not resumed with damaged results, see
    /// digest_of(). Empty: damage is not found.
    virtual std::string digest() const { return {}; }
    /// Amount written so far, in the writer's PositionUnit; stored in checkpoints.
    virtual std::int64_t position() const = 0;
};

/// Unit of a writer's position().
enum class PositionUnit {
    frames,  ///< of a VTKHDF file
    bytes,   ///< of a table
    files    ///< STEM.K.vtu, one for each frame, beside a list STEM.pvd
};

/// An entry of the writer table. A new output is one file that defines its entry and one line in
/// writer_list.def.
struct WriterEntry {
    const char* name;  ///< key in checkpoints: it must not change
    const char* file;  ///< file name; '*' is the stem of the result files
    PositionUnit unit;
    bool (*is_enabled)(const WriterContext& context);  ///< whether this run has the output
    std::unique_ptr<ResultWriter> (*make)(const WriterContext& context);
};
/// The file of a frame of a writer whose unit is `files`: "STEM.3.vtu".
std::string frame_file_name(const std::string& stem, std::int64_t index);

/// All writers, in the order of writer_list.def, in which they are called.
const std::vector<WriterEntry>& writer_table();

/// WriterEntry::is_enabled of an output that every run has.
constexpr bool is_always_written(const WriterContext&) {
    return true;
}
/// WriterEntry::make of a writer with a constructor from WriterContext.
template <class Writer>
std::unique_ptr<ResultWriter> make_writer(const WriterContext& context) {
    return std::make_unique<Writer>(context);
}

}  // namespace rockslope::dda
