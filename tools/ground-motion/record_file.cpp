#include "record_file.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "common/base/atomic_file.hpp"
#include "common/drawing/canvas.hpp"
#include "record/differentiate.hpp"
#include "record/record_text.hpp"

namespace rockslope {

namespace po = boost::program_options;

void add_source_options(po::options_description& options, RecordSource& source) {
    std::string known;
    for (const std::string& key : record::record_format_keys()) known += (known.empty() ? "" : ", ") + key;
    auto add = options.add_options();
    add("format", po::value(&source.format),
        ("format of the file (default: recognised by its content): " + known).c_str());
    add("quantity", po::value(&source.quantity),
        "quantity to read if the file contains several or does not state it: acceleration, velocity, "
        "displacement");
    add("unit", po::value(&source.unit),
        "unit of the values if the file does not state it: g, m/s2, cm/s2, ...");
    add("channel", po::value(&source.channels),
        "channel of a file with several, from 1; repeated for the next file");
    add("point", po::value(&source.points),
        "point and direction in the history.csv of a run: \"crest x\"; repeated for the next file");
}

void check_source(const RecordSource& source, std::size_t files) {
    if (source.channels.size() > files || source.points.size() > files)
        throw std::invalid_argument("--channel and --point are for one file each; there are " +
                                    std::to_string(files) + " files");
}

namespace {

template <class Value>
Value value_for_file(const std::vector<Value>& values, std::size_t place, Value fallback) {
    return values.empty() ? fallback : values[std::min(place, values.size() - 1)];
}

}  // namespace

record::Accelerogram read_accelerogram(const std::filesystem::path& path, const RecordSource& source,
                                       std::size_t place) {
    record::RecordDeclaration declaration;
    declaration.assumed_quantity = record::Quantity::acceleration;
    declaration.quantity = record::quantity_of_name(source.quantity);
    if (!source.quantity.empty() && !declaration.quantity)
        throw std::invalid_argument("--quantity must be acceleration, velocity or displacement");
    declaration.unit = source.unit;
    declaration.format = source.format;
    declaration.channel = value_for_file(source.channels, place, 1);
    declaration.point = value_for_file(source.points, place, std::string());
    const record::Record record = record::read_record(path, declaration);
    if (record.quantity != record::Quantity::acceleration)
        std::fprintf(stderr, "ground-motion: %s contains %s; it is differentiated by a cubic spline\n",
                     path.c_str(), record::quantity_name(record.quantity).c_str());
    return {record.dt, record::acceleration_samples(record)};
}

void check_record_name(const std::filesystem::path& path) {
    const std::string kind = path.extension().string();
    if (kind != ".at2" && kind != ".AT2" && kind != ".csv")
        throw std::invalid_argument(
            "--output is not a record file; expected a name that ends in .at2 or .csv");
}

void check_picture_name(const std::filesystem::path& path) {
    if (!picture_format(path))
        throw std::invalid_argument(
            "--picture is not a picture file; expected a name that ends in .svg, .png or .pdf");
}

void write_record(const std::filesystem::path& path, const record::Accelerogram& record,
                  const std::string& title, const std::string& heading) {
    write_file_atomically(path, path.extension() == ".csv" ? record::csv_text(record, title)
                                                           : record::at2_text(record, title, heading));
}

}  // namespace rockslope
