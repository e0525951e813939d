#include "record_commands.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>

#include "common/base/atomic_file.hpp"
#include "common/base/degree.hpp"
#include "common/base/output_check.hpp"
#include "measures_text.hpp"
#include "parse_subcommand.hpp"
#include "record/correct.hpp"
#include "record/match_spectrum.hpp"
#include "record/measures.hpp"
#include "record/newmark_block.hpp"
#include "record/resample.hpp"
#include "record/rotate.hpp"
#include "record/scale.hpp"
#include "record/trim.hpp"
#include "record_file.hpp"
#include "record_picture.hpp"
#include "support/picture_options.hpp"

namespace rockslope {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

/// The options that all subcommands share.
struct Request {
    std::vector<fs::path> inputs;
    RecordSource source;
    fs::path output, spectrum, picture;
    PageStyle style;  ///< of the picture
    double damping = 0.05;
    po::variables_map values;

    bool has(const char* option) const { return values.count(option) > 0; }
};

/// What is specific to a subcommand.
struct RecordOperation {
    std::string usage;
    std::size_t inputs = 1;
    bool writes = true;  ///< whether it writes a record to --output
    std::function<void(po::options_description&)> add_options = [](auto&) {};
    std::function<record::Accelerogram(const Request&, std::vector<record::Accelerogram>)> apply =
        [](const Request&, std::vector<record::Accelerogram> records) { return records.front(); };
};

po::options_description described(const RecordOperation& change, Request& request) {
    po::options_description options;
    auto add = options.add_options();
    if (change.writes)
        add("output,o", po::value(&request.output),
            "record to write: PEER AT2 in g, or two-column CSV in m/s2");
    change.add_options(options);
    add_source_options(options, request.source);
    add("spectrum", po::value(&request.spectrum), "also write the response spectrum, CSV");
    add("picture", po::value(&request.picture), "also draw the record and its 5 % spectrum, SVG, PNG or PDF");
    add("damping", po::value(&request.damping)->default_value(0.05, "0.05"),
        "damping of the oscillators, fraction of critical");
    tool_support::add_picture_options(options);
    return options;
}

void check(const RecordOperation& change, const Request& request) {
    if (request.inputs.size() != change.inputs)
        throw std::invalid_argument(std::to_string(request.inputs.size()) + " records are given; expected " +
                                    std::to_string(change.inputs));
    check_source(request.source, request.inputs.size());
    if (change.writes) check_record_name(request.output);
    if (!request.picture.empty()) check_picture_name(request.picture);
    std::vector<fs::path> read = request.inputs;
    if (request.has("target")) read.push_back(request.values["target"].as<fs::path>());
    for (const auto& path : {request.output, request.spectrum, request.picture})
        if (!path.empty()) check_output(path, read);
    check_distinct({request.output, request.spectrum, request.picture});
    if (!(request.damping >= 0 && request.damping < 1))
        throw std::invalid_argument("damping must be at least 0 and below 1");
}

std::string title_of(const RecordOperation& change, const Request& request) {
    std::string names;
    for (const fs::path& input : request.inputs) names += " " + input.filename().string();
    return change.usage.substr(0, change.usage.find(' ')) + " of" + names;
}

int perform(const RecordOperation& change, const std::vector<std::string>& arguments) {
    Request request;
    const auto values = parse_subcommand(change.usage, arguments, described(change, request));
    if (!values) return 0;
    request.values = *values;
    request.style = tool_support::picture_style(*values, "");
    for (const std::string& file : files_of(*values)) request.inputs.emplace_back(file);
    check(change, request);
    std::vector<record::Accelerogram> records;
    for (const fs::path& input : request.inputs)
        records.push_back(read_accelerogram(input, request.source, records.size()));
    const record::Accelerogram record = change.apply(request, std::move(records));
    const std::string title = title_of(change, request);
    if (change.writes) write_record(request.output, record, title, "PROCESSED STRONG MOTION RECORD");
    if (!request.spectrum.empty())
        write_file_atomically(request.spectrum, spectrum_text(record, request.damping));
    if (!request.picture.empty())
        record_picture({{title, record}}, title, request.style).write(request.picture);
    std::fputs(measures_text(record).c_str(), stdout);
    return 0;
}

int run_show(const std::vector<std::string>& arguments) {
    RecordOperation show{"show FILE [options]\nPrints peaks, Arias intensity and durations of a record"};
    show.writes = false;
    return perform(show, arguments);
}

int run_convert(const std::vector<std::string>& arguments) {
    return perform({"convert FILE -o FILE.at2|FILE.csv [options]\nWrites the acceleration unchanged"},
                   arguments);
}

int run_scale(const std::vector<std::string>& arguments) {
    RecordOperation change{
        "scale FILE -o FILE.at2|FILE.csv --peak|--arias|--ordinate|--factor VALUE [options]\n"
        "Multiplies the acceleration by a factor, or so that it has the given measure"};
    double peak = 0, arias = 0, ordinate = 0, period = 0, factor = 0;
    change.add_options = [&](po::options_description& options) {
        auto add = options.add_options();
        add("peak", po::value(&peak), "g, largest absolute acceleration");
        add("arias", po::value(&arias), "m/s, Arias intensity");
        add("ordinate", po::value(&ordinate),
            "g, absolute acceleration of an oscillator of --period and --damping");
        add("period", po::value(&period), "s");
        add("factor", po::value(&factor), "dimensionless; a negative factor reverses the motion");
    };
    change.apply = [&](const Request& request, std::vector<record::Accelerogram> records) {
        const bool has_ordinate = request.has("ordinate");
        if (request.has("peak") + request.has("arias") + has_ordinate + request.has("factor") != 1)
            throw std::invalid_argument(
                "scale needs exactly one of --peak, --arias, --ordinate and --factor");
        if (has_ordinate != request.has("period"))
            throw std::invalid_argument("--ordinate and --period go together");
        if (request.has("peak")) return record::scaled_to_peak(records[0], peak * record::standard_gravity);
        if (request.has("arias")) return record::scaled_to_arias(records[0], arias);
        if (has_ordinate)
            return record::scaled_to_ordinate(records[0], period, request.damping,
                                              ordinate * record::standard_gravity);
        return record::scaled(records[0], factor);
    };
    return perform(change, arguments);
}

int run_trim(const std::vector<std::string>& arguments) {
    RecordOperation change{
        "trim FILE -o FILE.at2|FILE.csv [--from S] [--to S] [options]\n"
        "Keeps a part of the record; its time starts at 0"};
    double from = 0, to = 0;
    change.add_options = [&](po::options_description& options) {
        auto add = options.add_options();
        add("from", po::value(&from)->default_value(0), "start, s");
        add("to", po::value(&to), "end, s (default: end of the record)");
    };
    change.apply = [&](const Request& request, std::vector<record::Accelerogram> records) {
        return record::trimmed(records[0], from, request.has("to") ? to : std::numeric_limits<double>::max());
    };
    return perform(change, arguments);
}

int run_resample(const std::vector<std::string>& arguments) {
    RecordOperation change{
        "resample FILE -o FILE.at2|FILE.csv --step S [options]\n"
        "Resamples the record; a longer step removes the frequencies that it cannot represent"};
    double step = 0;
    change.add_options = [&](po::options_description& options) {
        options.add_options()("step", po::value(&step)->required(), "s between samples");
    };
    change.apply = [&](const Request&, std::vector<record::Accelerogram> records) {
        return record::resampled(records[0], step);
    };
    return perform(change, arguments);
}

int run_rotate(const std::vector<std::string>& arguments) {
    RecordOperation change{
        "rotate FILE FILE -o FILE.at2|FILE.csv --azimuth A --azimuth B --section C [options]\n"
        "Computes the motion along a section from two horizontal components"};
    change.inputs = 2;
    std::vector<double> azimuths;
    double section = 0;
    change.add_options = [&](po::options_description& options) {
        auto add = options.add_options();
        add("azimuth", po::value(&azimuths)->required(),
            "azimuth of a file's positive direction, degrees clockwise from north; once for each file");
        add("section", po::value(&section)->required(),
            "azimuth of the section's x axis, degrees clockwise from north");
    };
    change.apply = [&](const Request&, std::vector<record::Accelerogram> records) {
        if (azimuths.size() != 2)
            throw std::invalid_argument("rotate needs --azimuth twice, once for each file");
        if (records[0].values.size() != records[1].values.size())
            std::fprintf(stderr, "the components last %.10g s and %.10g s: the longer one is cut\n",
                         records[0].duration(), records[1].duration());
        return record::rotated({records[0], azimuths[0]}, {records[1], azimuths[1]}, section);
    };
    return perform(change, arguments);
}

int run_correct(const std::vector<std::string>& arguments) {
    RecordOperation change{
        "correct FILE -o FILE.at2|FILE.csv [corrections] [options]\n"
        "Removes the drift of a raw record by the given corrections, in this order"};
    double mean = 0, taper = 0, corner = 0;
    int degree = 0, order = 0;
    std::vector<double> shift;
    change.add_options = [&](po::options_description& options) {
        auto add = options.add_options();
        add("mean", po::value(&mean),
            "subtract the mean of the time before the event, s; 0: of the whole record");
        add("trend", po::value(&degree),
            "fit a polynomial of this degree, 1 to 3, to the velocity and subtract its derivative");
        add("shift", po::value(&shift),
            "start and end of the shaking, s, given twice: brings the ground to rest at the end, so that a "
            "permanent displacement remains");
        add("taper", po::value(&taper), "length of the taper at both ends, s");
        add("high-pass", po::value(&corner),
            "corner frequency, Hz, of a zero-phase Butterworth filter with zero padding at both ends");
        add("order", po::value(&order)->default_value(4), "order of the filter, 1 to 12");
    };
    change.apply = [&](const Request& request, std::vector<record::Accelerogram> records) {
        record::Accelerogram record = records[0];
        if (request.has("mean")) record = record::without_mean(record, mean);
        if (request.has("trend")) record = record::without_velocity_trend(record, degree);
        if (request.has("shift")) {
            if (shift.size() != 2) throw std::invalid_argument("correct needs --shift twice: begin and end");
            record = record::correct_baseline_shift(record, shift[0], shift[1]);
        }
        if (request.has("taper")) record = record::tapered(record, taper);
        if (request.has("high-pass")) record = record::high_passed(record, corner, order);
        return record;
    };
    return perform(change, arguments);
}

int run_match(const std::vector<std::string>& arguments) {
    RecordOperation change{
        "match FILE -o FILE.at2|FILE.csv --target SPECTRUM.csv [options]\n"
        "Changes the record until its response spectrum matches the target"};
    fs::path file;
    int rounds = 0;
    change.add_options = [&](po::options_description& options) {
        auto add = options.add_options();
        add("target", po::value(&file)->required(),
            "two columns with the heading \"period (s),acceleration (g)\"");
        add("rounds", po::value(&rounds)->default_value(30),
            "rounds, 0 to 100, in the frequency domain and as many in the time domain; the best is kept");
    };
    change.apply = [&](const Request& request, std::vector<record::Accelerogram> records) {
        const record::SpectralMatch match =
            record::match_spectrum(records[0], record::read_target_spectrum(file), request.damping, rounds);
        std::fprintf(stderr, "off the target by %.1f %% in the mean, %.1f %% at most\n",
                     100 * match.mean_misfit, 100 * match.largest_misfit);
        return match.record;
    };
    return perform(change, arguments);
}

std::string slide_text(const record::Accelerogram& record, const record::SlidingPlane& plane,
                       const char* direction) {
    const std::vector<double> slip = record::newmark_slip(record, plane);
    const auto first = std::find_if(slip.begin(), slip.end(), [](double s) { return s != 0; });
    std::array<char, 160> text{};
    if (first == slip.end()) return std::string("plane falling towards ") + direction + ": no slip\n";
    std::snprintf(text.data(), text.size(), "plane falling towards %s: slip %.4f m, first at %.3f s\n",
                  direction, slip.back(), static_cast<double>(first - slip.begin()) * record.step);
    return text.data();
}

int run_slide(const std::vector<std::string>& arguments) {
    RecordOperation change{
        "slide FILE --dip DEGREES --friction DEGREES [options]\n"
        "Newmark's estimate of the slip of a rigid block on an inclined plane"};
    change.writes = false;
    double dip = 0, friction = 0;
    change.add_options = [&](po::options_description& options) {
        auto add = options.add_options();
        add("dip", po::value(&dip)->required(), "dip of the plane, degrees");
        add("friction", po::value(&friction)->required(), "friction angle, degrees");
    };
    change.apply = [&](const Request&, std::vector<record::Accelerogram> records) {
        const record::SlidingPlane plane{dip * degree, friction * degree};
        const std::string text =
            slide_text(records[0], plane, "+x") + slide_text(record::scaled(records[0], -1), plane, "-x");
        std::printf("yield acceleration %.4f g\n%s", record::yield_coefficient(plane), text.c_str());
        return records[0];
    };
    return perform(change, arguments);
}

}  // namespace

const std::vector<RecordCommand>& record_commands() {
    static const std::vector<RecordCommand> commands = {
        {"synthesise", "make an artificial accelerogram", run_synthesise},
        {"show", "print peaks, Arias intensity, durations; --spectrum and --picture for more", run_show},
        {"convert", "write a record as PEER AT2 or CSV", run_convert},
        {"scale", "scale to a peak, an Arias intensity or a spectral ordinate", run_scale},
        {"trim", "keep a part of a record", run_trim},
        {"resample", "change the time step", run_resample},
        {"rotate", "rotate two horizontal components to the section's azimuth", run_rotate},
        {"correct", "remove the drift of a raw record", run_correct},
        {"match", "match the response spectrum to a target", run_match},
        {"slide", "Newmark's estimate of a block's slip on a plane", run_slide},
        {"plot", "draw one or several records", run_plot},
        {"compare", "compare the displacement of a point in several runs", run_compare},
        {"amplification", "compute peak and spectral ratios of two records", run_amplification},
    };
    return commands;
}

}  // namespace rockslope
