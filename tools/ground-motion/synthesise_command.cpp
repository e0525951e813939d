#include "record_commands.hpp"

#include <array>
#include <boost/program_options.hpp>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "common/base/atomic_file.hpp"
#include "common/base/output_check.hpp"
#include "common/base/text.hpp"
#include "measures_text.hpp"
#include "parse_subcommand.hpp"
#include "record/measures.hpp"
#include "record/synthesise.hpp"
#include "record/wavelets.hpp"
#include "record_file.hpp"
#include "record_picture.hpp"
#include "support/picture_options.hpp"

namespace rockslope {

namespace po = boost::program_options;

namespace {

struct SynthesisRequest {
    record::SyntheticMotion recipe;
    std::int64_t seed = 1;
    double peak_in_g = 0.35;
    double magnitude = 6.5;
    double distance = 15;
    std::string kind = "random";
    double frequency = 2;
    int cycles = 10;
    std::filesystem::path output;
    std::filesystem::path spectrum;
    std::filesystem::path picture;
};

template <class Value>
po::typed_value<Value>* option(Value& value) {
    return po::value(&value)->default_value(value, shortest_text(static_cast<double>(value)));
}

po::options_description described(SynthesisRequest& request) {
    record::SyntheticMotion& recipe = request.recipe;
    po::options_description options;
    auto add = options.add_options();
    add("output,o", po::value(&request.output), "record to write: PEER AT2 in g, or two-column CSV in m/s2");
    add("spectrum", po::value(&request.spectrum), "also write the 5 % response spectrum, CSV");
    add("picture", po::value(&request.picture), "also draw the record, SVG, PNG or PDF");
    add("kind", po::value(&request.kind)->default_value("random"),
        "random, sine (a burst) or ricker (a wavelet); sine and ricker use only --peak, --step, --frequency "
        "and --cycles");
    add("frequency", option(request.frequency), "frequency of a sine or a Ricker wavelet, Hz");
    add("cycles", po::value(&request.cycles)->default_value(10), "number of cycles of a sine");
    add("seed", option(request.seed), "seed of the random phases");
    add("step", option(recipe.step), "time step, s");
    add("duration", option(recipe.duration), "duration, s");
    add("peak", option(request.peak_in_g), "largest absolute acceleration, g");
    add("magnitude", option(request.magnitude),
        "moment magnitude; it determines the envelope together with the distance");
    add("distance", option(request.distance), "distance from the source, km");
    add("ground-frequency", option(recipe.spectrum.ground_frequency),
        "frequency of the Kanai-Tajimi filter, Hz");
    add("ground-damping", option(recipe.spectrum.ground_damping),
        "damping of the Kanai-Tajimi filter, fraction of critical");
    add("low-cut-frequency", option(recipe.spectrum.low_cut_frequency),
        "frequency of the Clough-Penzien filter, Hz");
    add("low-cut-damping", option(recipe.spectrum.low_cut_damping),
        "damping of the Clough-Penzien filter, fraction of critical");
    tool_support::add_picture_options(options);
    add("kappa", option(recipe.spectrum.kappa), "s, attenuation of high frequencies near the surface");
    return options;
}

std::string title(const SynthesisRequest& request) {
    std::array<char, 160> text{};
    if (request.kind != "random") {
        std::snprintf(text.data(), text.size(), "%s of %g Hz", request.kind.c_str(), request.frequency);
        return text.data();
    }
    std::snprintf(text.data(), text.size(), "artificial record, M %g at %g km, Kanai-Tajimi %g Hz, seed %llu",
                  request.magnitude, request.distance, request.recipe.spectrum.ground_frequency,
                  static_cast<unsigned long long>(request.recipe.seed));
    return text.data();
}

record::Accelerogram synthesised_record(SynthesisRequest& request) {
    const double peak = request.peak_in_g * record::standard_gravity;
    if (request.kind == "sine")
        return record::sine_burst(peak, request.frequency, request.cycles, request.recipe.step);
    if (request.kind == "ricker") return record::ricker(peak, request.frequency, request.recipe.step);
    if (request.kind != "random") throw std::invalid_argument("--kind must be random, sine or ricker");
    request.recipe.seed = static_cast<std::uint64_t>(request.seed);
    request.recipe.peak = peak;
    request.recipe.envelope = record::envelope_of_earthquake(request.magnitude, request.distance);
    return record::synthesise(request.recipe);
}

}  // namespace

int run_synthesise(const std::vector<std::string>& arguments) {
    SynthesisRequest request;
    const auto values = parse_subcommand(
        "synthesise -o FILE.at2|FILE.csv [options]\n"
        "Makes an artificial accelerogram; the same options give the same bytes",
        arguments, described(request));
    if (!values) return 0;
    if (!files_of(*values).empty())
        throw std::invalid_argument("synthesise reads no file, but is given '" + files_of(*values).front() +
                                    "'");
    const PageStyle style = tool_support::picture_style(*values, "");
    check_record_name(request.output);
    if (!request.picture.empty()) check_picture_name(request.picture);
    for (const auto& path : {request.output, request.spectrum, request.picture})
        if (!path.empty()) check_output(path, {});
    check_distinct({request.output, request.spectrum, request.picture});
    if (request.seed < 0) throw std::invalid_argument("seed must not be negative");
    const record::Accelerogram record = synthesised_record(request);
    write_record(request.output, record, title(request), "SYNTHETIC STRONG MOTION RECORD");
    if (!request.spectrum.empty()) {
        write_file_atomically(request.spectrum, spectrum_text(record, 0.05));
    }
    if (!request.picture.empty()) {
        record_picture({{"", record}}, title(request), style).write(request.picture);
    }
    std::fputs(measures_text(record).c_str(), stdout);
    return 0;
}

}  // namespace rockslope
