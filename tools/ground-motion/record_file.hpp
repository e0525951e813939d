#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope {

/// Options for reading the record files.
struct RecordSource {
    std::string format;
    std::string unit;
    std::string quantity;
    std::vector<int> channels;        ///< one for each file; the last applies to all further files
    std::vector<std::string> points;  ///< one for each file; the last applies to all further files
};

/// --format, --quantity, --unit, --channel and --point.
void add_source_options(boost::program_options::options_description& options, RecordSource& source);

/// Reads the acceleration of a file. @param place position of the file on the command line, from 0. A
/// velocity or displacement is differentiated, with a note on stderr. @throws InputError as the readers do.
record::Accelerogram read_accelerogram(const std::filesystem::path& path, const RecordSource& source,
                                       std::size_t place = 0);

/// @throws std::invalid_argument when --channel or --point is given more often than there are files.
void check_source(const RecordSource& source, std::size_t files);

/// @throws std::invalid_argument when the file name of a record ends in neither .at2 nor .csv.
void check_record_name(const std::filesystem::path& path);
/// @throws std::invalid_argument when the file name of a picture does not end in .svg, .png or .pdf.
void check_picture_name(const std::filesystem::path& path);

/// Writes PEER AT2 in g, or two columns in m/s2 if the name ends in .csv. @throws OutputError.
void write_record(const std::filesystem::path& path, const record::Accelerogram& record,
                  const std::string& title, const std::string& heading);

}  // namespace rockslope
