#include "record_commands.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/base/atomic_file.hpp"
#include "common/base/output_check.hpp"
#include "formatted.hpp"
#include "measures_text.hpp"
#include "parse_subcommand.hpp"
#include "record/amplification.hpp"
#include "record/measures.hpp"
#include "record/records.hpp"
#include "record_file.hpp"
#include "record_picture.hpp"
#include "support/picture_options.hpp"

namespace rockslope {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

struct Comparison {
    std::vector<std::string> files;
    RecordSource source;
    fs::path output, picture;
    PageStyle style;  ///< of the picture
    double damping = 0.05;
    std::string point;
    std::vector<std::string> labels;
};

/// Parses the arguments of a subcommand; false when a text about it was printed instead.
bool parse(const std::string& usage, const std::vector<std::string>& arguments,
           po::options_description& options, Comparison& request) {
    tool_support::add_picture_options(options);
    const auto values = parse_subcommand(usage, arguments, options);
    if (!values) return false;
    request.files = files_of(*values);
    request.style = tool_support::picture_style(*values, "");
    return true;
}

void check_outputs(const Comparison& request) {
    const std::vector<fs::path> read(request.files.begin(), request.files.end());
    for (const fs::path& path : {request.output, request.picture})
        if (!path.empty()) check_output(path, read);
    check_distinct({request.output, request.picture});
}

std::vector<NamedRecord> read_all(const Comparison& request) {
    std::vector<NamedRecord> records;
    for (const std::string& file : request.files) {
        const std::size_t place = records.size();
        const auto& points = request.source.points;
        std::string name = fs::path(file).filename().string();
        if (!points.empty()) name += ": " + points[std::min(place, points.size() - 1)];
        records.push_back({name, read_accelerogram(file, request.source, place)});
    }
    return records;
}

/// 61 periods from 0.02 to 6.3 s, except those longer than a third of the record, s.
std::vector<double> compared_periods(double duration) {
    std::vector<double> periods;
    for (int k = 0; k <= 60; ++k) {
        const double period = 0.02 * std::pow(10.0, k / 24.0);
        if (k > 0 && period > duration / 3) break;
        periods.push_back(period);
    }
    return periods;
}

/// Displacement of a point in one run, m.
struct Track {
    std::string label;
    std::vector<double> time, x, y;

    double distance(std::size_t k) const { return std::hypot(x[k], y[k]); }
    std::size_t farthest() const {
        std::size_t best = 0;
        for (std::size_t k = 1; k < x.size(); ++k)
            if (distance(k) > distance(best)) best = k;
        return best;
    }
};

/// Reads the displacement of a point in the last stage of a run.
Track read_track(const std::string& file, const std::string& point, const std::string& label) {
    Track track{label, {}, {}, {}};
    for (const char direction : {'x', 'y'}) {
        record::RecordDeclaration declaration;
        declaration.quantity = record::Quantity::displacement;
        declaration.format = "run";
        declaration.point = point + " " + direction;
        const record::Record record = record::read_record(file, declaration);
        (direction == 'x' ? track.x : track.y) = record.values;
        track.time.resize(record.values.size());
        for (std::size_t k = 0; k < track.time.size(); ++k)
            track.time[k] = static_cast<double>(k) * record.dt;
    }
    return track;
}

std::string tracks_text(const std::vector<Track>& tracks) {
    std::string text = "run,end (s),final x (m),final y (m),final distance (m),largest distance (m),at (s)\n";
    for (const Track& track : tracks) {
        const std::size_t last = track.x.size() - 1, far = track.farthest();
        text += track.label + formatted(",%.6g,%.5f,%.5f,%.5f,%.5f,%.6g\n", track.time[last], track.x[last],
                                        track.y[last], track.distance(last), track.distance(far),
                                        track.time[far]);
    }
    return text;
}

std::string table_text(const std::vector<record::Amplification>& table) {
    std::string text =
        "period (s),frequency (Hz),response of the point (g),response of the base (g),response ratio,Fourier "
        "ratio\n";
    for (const record::Amplification& a : table)
        text += formatted("%.4f,%.4f,%.5f,%.5f,%.4f,%.4f\n", a.period, 1 / a.period,
                          a.response / record::standard_gravity, a.base_response / record::standard_gravity,
                          a.response_ratio(), a.fourier_ratio);
    return text;
}

// Below this fraction of the base's largest Fourier amplitude, the Fourier ratio is not significant.
constexpr double min_drawn_base = 0.05;

Canvas ratio_picture(const std::vector<record::Amplification>& table, const std::string& title,
                     const PageStyle& style) {
    PictureCurve response{"response spectra", {}, {}}, fourier{"Fourier spectra, smoothed", {}, {}};
    for (const record::Amplification& a : table) {
        response.x.push_back(a.period);
        response.y.push_back(a.response_ratio());
        if (a.base_fourier < min_drawn_base) continue;
        fourier.x.push_back(a.period);
        fourier.y.push_back(a.fourier_ratio);
    }
    return period_picture({response, fourier}, title, "amplification", style);
}

}  // namespace

int run_plot(const std::vector<std::string>& arguments) {
    Comparison request;
    po::options_description options;
    options.add_options()("output,o", po::value(&request.picture), "picture to write: SVG, PNG or PDF");
    add_source_options(options, request.source);
    const std::string usage =
        "plot FILE [FILE ...] -o PICTURE [options]\n"
        "Draws accelerations, velocities, displacements and 5 % spectra into one picture";
    if (!parse(usage, arguments, options, request)) return 0;
    if (request.files.empty()) throw std::invalid_argument("0 records are given; expected one or more");
    if (!picture_format(request.picture))
        throw std::invalid_argument(
            "--output is not a picture file; expected a name that ends in .svg, .png or .pdf");
    check_source(request.source, request.files.size());
    check_outputs(request);
    const std::vector<NamedRecord> records = read_all(request);
    record_picture(records, records.size() == 1 ? records[0].name : "records of ground motion", request.style)
        .write(request.picture);
    return 0;
}

int run_compare(const std::vector<std::string>& arguments) {
    Comparison request;
    po::options_description options;
    auto add = options.add_options();
    add("point", po::value(&request.point)->required(), "name of the measured point");
    add("label", po::value(&request.labels), "label of a run, once for each (default: their folders)");
    add("output,o", po::value(&request.output), "write the printed table, CSV");
    add("picture", po::value(&request.picture), "draw the displacements against time, SVG, PNG or PDF");
    const std::string usage =
        "compare RELATIVE.csv [RELATIVE.csv ...] --point NAME [options]\n"
        "Compares the displacement of a measured point in the last stage of several runs, from the "
        "relative.csv or history.csv of each";
    if (!parse(usage, arguments, options, request)) return 0;
    if (request.files.empty()) throw std::invalid_argument("0 runs are given; expected one or more");
    if (!request.labels.empty() && request.labels.size() != request.files.size())
        throw std::invalid_argument(std::to_string(request.labels.size()) + " labels are given; expected " +
                                    std::to_string(request.files.size()));
    if (!request.picture.empty()) check_picture_name(request.picture);
    check_outputs(request);
    std::vector<Track> tracks;
    for (std::size_t k = 0; k < request.files.size(); ++k) {
        const fs::path file = request.files[k];
        const std::string folder = file.parent_path().filename().string();
        tracks.push_back(
            read_track(request.files[k], request.point, request.labels.empty() ? folder : request.labels[k]));
    }
    if (!request.output.empty()) write_file_atomically(request.output, tracks_text(tracks));
    if (!request.picture.empty()) {
        std::vector<PictureCurve> x, y;
        for (const Track& track : tracks) {
            x.push_back({track.label, track.time, track.x});
            y.push_back({track.label, track.time, track.y});
        }
        displacement_picture(x, y, "displacement of '" + request.point + "'", request.style)
            .write(request.picture);
    }
    std::fputs(tracks_text(tracks).c_str(), stdout);
    return 0;
}

int run_amplification(const std::vector<std::string>& arguments) {
    Comparison request;
    po::options_description options;
    auto add = options.add_options();
    add("output,o", po::value(&request.output), "write the ratios at 61 periods, CSV");
    add("picture", po::value(&request.picture), "draw the ratios against the period, SVG, PNG or PDF");
    add("damping", po::value(&request.damping)->default_value(0.05, "0.05"),
        "damping of the oscillators, fraction of critical");
    add_source_options(options, request.source);
    const std::string usage =
        "amplification POINT BASE [-o TABLE.csv] [options]\n"
        "Computes the ratios of two records: peaks, response spectra, Fourier spectra";
    if (!parse(usage, arguments, options, request)) return 0;
    if (request.files.size() != 2)
        throw std::invalid_argument(std::to_string(request.files.size()) + " records are given; expected 2");
    if (!request.picture.empty()) check_picture_name(request.picture);
    check_source(request.source, 2);
    check_outputs(request);
    const std::vector<NamedRecord> records = read_all(request);
    const record::Accelerogram &point = records[0].record, &base = records[1].record;
    const auto table = record::amplification(
        point, base, compared_periods(std::min(point.duration(), base.duration())), request.damping);
    if (!request.output.empty()) write_file_atomically(request.output, table_text(table));
    if (!request.picture.empty())
        ratio_picture(table, records[0].name + " over " + records[1].name, request.style)
            .write(request.picture);

    const record::RecordMeasures m = record::measure(point), b = record::measure(base);
    const auto ratio = [](double a, double c) { return c > 0 ? a / c : 0; };
    const auto largest = std::max_element(table.begin(), table.end(), [](const auto& x, const auto& y) {
        return x.response_ratio() < y.response_ratio();
    });
    std::fputs(formatted("peak acceleration %.4f g over %.4f g: %.3f\n",
                         m.peak_acceleration / record::standard_gravity,
                         b.peak_acceleration / record::standard_gravity,
                         ratio(m.peak_acceleration, b.peak_acceleration))
                   .c_str(),
               stdout);
    std::fputs(formatted("peak velocity %.4f m/s over %.4f m/s: %.3f\n", m.peak_velocity, b.peak_velocity,
                         ratio(m.peak_velocity, b.peak_velocity))
                   .c_str(),
               stdout);
    std::fputs(formatted("response spectra: largest ratio %.3f, at a period of %.3f s\n",
                         largest->response_ratio(), largest->period)
                   .c_str(),
               stdout);
    return 0;
}

}  // namespace rockslope
