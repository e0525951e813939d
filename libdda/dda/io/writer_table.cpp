#include "dda/io/result_writer.hpp"

namespace dda {

const std::vector<WriterEntry>& writer_table() {
    const auto always = [](const WriterContext&) { return true; };
    static const std::vector<WriterEntry> table = {
        {"blocks", always, make_block_frames},
        {"joints", always, make_joint_frames},
        {"history", always, make_history_csv},
        {"steps", always, make_steps_csv},
        {"pvd", [](const WriterContext& context) { return context.pvd; }, make_pvd},
    };
    return table;
}

}  // namespace dda
