#pragma once

#include <string>

#include "dda/writers/csv_file.hpp"
#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

/// A writer of one table.
class CsvWriter : public ResultWriter {
  public:
    std::int64_t position() const override { return table_.size(); }
    void cut() override { table_.cut(); }
    void sync() override { table_.sync(); }
    std::string digest() const override { return table_.digest(); }

  protected:
    /// @param file name of the table in the folder of the results.
    CsvWriter(const WriterContext& context, const std::string& file)
        : table_(context.folder / file, context.resume_from) {}
    CsvFile& table() { return table_; }
    const CsvFile& table() const { return table_; }

  private:
    CsvFile table_;
};

}  // namespace rockslope::dda
