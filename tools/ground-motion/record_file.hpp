#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "record/accelerogram.hpp"
#include "record/records.hpp"

namespace rockslope {

/// What the command line says of the records that are read.
struct RecordSource {
    std::string format;
    std::string unit;
    std::string quantity;
    std::vector<int> channels;        ///< of the first file, the second, ...; the last stands for the rest
    std::vector<std::string> points;  ///< likewise
};

/// --format, --quantity, --unit, --channel and --point.
void add_source_options(boost::program_options::options_description& options, RecordSource& source);

/// The acceleration in the file that stands at `place` of the command line, from 0. A velocity or a
/// displacement is differentiated, and a line on the standard error says so. @throws InputError as the
/// readers do.
record::Accelerogram read_accelerogram(const std::filesystem::path& path, const RecordSource& source,
                                       std::size_t place = 0);

/// Refuses --channel or --point more often than there are files. @throws std::invalid_argument.
void check_source(const RecordSource& source, std::size_t files);

/// Refuses a record's file name that ends in neither .at2 nor .csv. @throws std::invalid_argument.
void check_record_name(const std::filesystem::path& path);
/// Refuses a picture's file name that ends in none of .svg, .png, .pdf. @throws std::invalid_argument.
void check_picture_name(const std::filesystem::path& path);

/// Writes PEER AT2 in g or two columns in m/s2, by the name. @throws OutputError.
void write_record(const std::filesystem::path& path, const record::Accelerogram& record,
                  const std::string& title, const std::string& heading);

}  // namespace rockslope
