#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dda/analysis/run.hpp"

namespace rockslope::dda {

/// What every writer is made from. `model` outlives the writer.
struct WriterContext {
    const Model& model;
    std::filesystem::path folder;
    std::string name;                         ///< stem of the result files
    std::optional<std::int64_t> resume_from;  ///< position() of the checkpoint; absent for a fresh run
    bool pvd = false;
    std::string relative_to = {};  ///< a tracked point's name; empty: none
};

/// One kind of result. A writer overrides what it is interested in; each call leaves its file whole on disk.
/// @throws OutputError naming the file: disk full, or a value that is not finite.
class ResultWriter {
  public:
    virtual ~ResultWriter() = default;
    /// A frame that is kept.
    virtual void frame(const State&) {}
    /// A row of the histories of measured points.
    virtual void history(const State&, const Stage&) {}
    /// An accepted step.
    virtual void step(const State&, const Stage&, const StepReport&) {}
    /// Where the next output goes, in the writer's own count (frames, bytes).
    virtual std::int64_t position() const = 0;
};

/// What a writer's position() counts.
enum class PositionUnit {
    frames,  ///< of a VTKHDF file
    bytes,   ///< of a table
    none     ///< nothing that its own file could be checked for
};

/// One row of the table of results: a new output is one file and one row.
struct WriterEntry {
    const char* name;
    const char* file;  ///< what it writes; '*' stands for the stem of the results
    PositionUnit unit;
    bool (*is_enabled)(const WriterContext& context);
    std::unique_ptr<ResultWriter> (*make)(const WriterContext& context);
};
const std::vector<WriterEntry>& writer_table();

std::unique_ptr<ResultWriter> make_block_frames(const WriterContext& context);
std::unique_ptr<ResultWriter> make_joint_frames(const WriterContext& context);
std::unique_ptr<ResultWriter> make_history_csv(const WriterContext& context);
std::unique_ptr<ResultWriter> make_relative_csv(const WriterContext& context);
std::unique_ptr<ResultWriter> make_joints_csv(const WriterContext& context);
std::unique_ptr<ResultWriter> make_steps_csv(const WriterContext& context);
std::unique_ptr<ResultWriter> make_pvd(const WriterContext& context);

}  // namespace rockslope::dda
