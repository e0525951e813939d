#include "record_file.hpp"

#include <stdexcept>

#include "blockgen/base/atomic_file.hpp"
#include "blockgen/picture/canvas.hpp"
#include "dda/record/record_text.hpp"

namespace po = boost::program_options;

void add_source_options(po::options_description& options, RecordSource& source) {
    std::string known;
    for (const std::string& key : dda::record_format_keys()) known += (known.empty() ? "" : ", ") + key;
    auto add = options.add_options();
    add("format", po::value(&source.format),
        ("of the file, in place of what its content looks like: " + known).c_str());
    add("unit", po::value(&source.unit),
        "of its values, where the file does not say: g, m/s2, cm/s2, gal, mm/s2");
    add("channel", po::value(&source.channel)->default_value(1), "of a file that stacks several, from 1");
}

dda::Accelerogram read_accelerogram(const std::filesystem::path& path, const RecordSource& source) {
    dda::RecordDeclaration declaration;
    declaration.quantity = dda::Quantity::acceleration;
    declaration.unit = source.unit;
    declaration.format = source.format;
    declaration.channel = source.channel;
    dda::Record record = dda::read_record(path, declaration);
    return {record.dt, std::move(record.values)};
}

void check_record_name(const std::filesystem::path& path) {
    const std::string kind = path.extension().string();
    if (kind != ".at2" && kind != ".AT2" && kind != ".csv")
        throw std::invalid_argument(
            "--output names no record file; expected a name that ends in .at2 or .csv");
}

void check_picture_name(const std::filesystem::path& path) {
    if (!blockgen::picture_format(path))
        throw std::invalid_argument(
            "--picture names no picture file; expected a name that ends in .svg, .png or .pdf");
}

void write_record(const std::filesystem::path& path, const dda::Accelerogram& record,
                  const std::string& title, const std::string& heading) {
    blockgen::write_file_atomically(path, path.extension() == ".csv" ? dda::csv_text(record, title)
                                                                     : dda::at2_text(record, title, heading));
}
