#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <string>

#include "dda/record/accelerogram.hpp"
#include "dda/record/records.hpp"

/// What the command line says of a record that is read.
struct RecordSource {
    std::string format;
    std::string unit;
    int channel = 1;
};

/// --format, --unit and --channel.
void add_source_options(boost::program_options::options_description& options, RecordSource& source);

/// The acceleration in a file. @throws InputError as the readers do, also for a file of velocity or
/// displacement only.
dda::Accelerogram read_accelerogram(const std::filesystem::path& path, const RecordSource& source);

/// Refuses a record's file name that ends in neither .at2 nor .csv. @throws std::invalid_argument.
void check_record_name(const std::filesystem::path& path);
/// Refuses a picture's file name that ends in none of .svg, .png, .pdf. @throws std::invalid_argument.
void check_picture_name(const std::filesystem::path& path);

/// Writes PEER AT2 in g or two columns in m/s2, by the name. @throws OutputError.
void write_record(const std::filesystem::path& path, const dda::Accelerogram& record,
                  const std::string& title, const std::string& heading);
