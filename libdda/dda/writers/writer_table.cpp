#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

const std::vector<WriterEntry>& writer_table() {
    const auto always = [](const WriterContext&) { return true; };
    static const std::vector<WriterEntry> table = {
        {"blocks", "*.vtkhdf", PositionUnit::frames, always, make_block_frames},
        {"joints", "*.joints.vtkhdf", PositionUnit::frames, always, make_joint_frames},
        {"history", "history.csv", PositionUnit::bytes, always, make_history_csv},
        {"relative", "relative.csv", PositionUnit::bytes,
         [](const WriterContext& context) { return !context.relative_to.empty(); }, make_relative_csv},
        {"measured joints", "joints.csv", PositionUnit::bytes,
         [](const WriterContext& context) { return !context.model.measured_joints.empty(); },
         make_joints_csv},
        {"steps", "steps.csv", PositionUnit::bytes, always, make_steps_csv},
        {"pvd", "*.pvd", PositionUnit::none, [](const WriterContext& context) { return context.pvd; },
         make_pvd},
    };
    return table;
}

}  // namespace rockslope::dda
