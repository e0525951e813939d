#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

#define WRITER(entry) WriterEntry entry();
#include "dda/writers/writer_list.def"
#undef WRITER

const std::vector<WriterEntry>& writer_table() {
    static const std::vector<WriterEntry> table = {
#define WRITER(entry) entry(),
#include "dda/writers/writer_list.def"
#undef WRITER
    };
    return table;
}

}  // namespace rockslope::dda
