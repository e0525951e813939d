#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>

#include "row.hpp"
#include "scenes.hpp"

namespace {

constexpr const char* usage =
    "bench_scenes --wall COLUMNSxROWS [--step S] [--duration S] | --model RUN.toml --blocks FILE --out "
    "FOLDER\n"
    "    [--threads N] [--repeat N] [--commit NAME] [--no-heading]\n"
    "Runs a scene N times and prints the median run as CSV, a row for each stage.\n";

using Options = std::map<std::string, std::string>;

Options read_options(int argc, char** argv) {
    Options options{{"--step", "0.005"},
                    {"--duration", "1"},
                    {"--threads", "1"},
                    {"--repeat", "1"},
                    {"--commit", "unnamed"}};
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        if (name == "--no-heading")
            options[name] = "yes";
        else if (name.rfind("--", 0) == 0 && i + 1 < argc)
            options[name] = argv[++i];
        else
            throw std::invalid_argument(name);
    }
    return options;
}

template <class Number>
Number positive(const std::string& text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value > 0))
        throw std::invalid_argument(text + " is not a positive number");
    return value;
}

bench::Outcome run_once(const Options& options, int threads) {
    if (options.count("--model"))
        return bench::run_model(options.at("--model"), options.at("--blocks"), options.at("--out"), threads);
    const std::string& size = options.at("--wall");
    const std::size_t cross = std::min(size.find('x'), size.size());
    return bench::run_wall(
        positive<int>(size.substr(0, cross)), positive<int>(size.substr(std::min(cross + 1, size.size()))),
        positive<double>(options.at("--step")), positive<double>(options.at("--duration")), threads);
}

void measure(const Options& options) {
    const int threads = positive<int>(options.at("--threads"));
    const bench::Conditions conditions = bench::present_conditions(options.at("--commit"), threads);
    bench::Outcome outcome;
    std::vector<std::vector<bench::StageFigures>> runs;
    for (int i = positive<int>(options.at("--repeat")); i > 0; --i) {
        outcome = run_once(options, threads);
        runs.push_back(outcome.stages);
    }
    if (!options.count("--no-heading")) std::fputs(bench::csv_heading().c_str(), stdout);
    for (const bench::StageFigures& figures : bench::median_run(runs))
        std::fputs(bench::csv_row(outcome.scene, outcome.blocks, figures, conditions).c_str(), stdout);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        measure(read_options(argc, argv));
    } catch (const std::logic_error&) {
        std::fputs(usage, stderr);
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_scenes: %s\n", error.what());
        return 1;
    }
    return 0;
}
