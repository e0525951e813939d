#include "row.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace rockslope::bench {

namespace {

std::string processor() {
    std::ifstream lines("/proc/cpuinfo");
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string number(double value, const char* format = "%.4g") {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

std::string quoted(const std::string& text) {
    return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

}  // namespace

Conditions present_conditions(const std::string& commit, int threads) {
    Conditions now;
    now.machine = processor() + " x " + std::to_string(std::thread::hardware_concurrency());
    if (getloadavg(&now.load, 1) != 1) now.load = -1;
    now.compiler = BENCH_COMPILER;
    now.commit = commit;
    now.threads = threads;
    return now;
}

std::string csv_heading() {
    return "scene,stage,machine,load,compiler,commit,threads,blocks,step (s),steps,mean iterations,"
           "factorizations per step,cuts,wall (s),us per block and step,residual over input energy\n";
}

std::string csv_row(const std::string& scene, int blocks, const StageStatistics& f, const Conditions& c) {
    const double steps = static_cast<double>(f.steps);
    const std::string fields[] = {scene,
                                  quoted(f.stage),
                                  quoted(c.machine),
                                  number(c.load),
                                  quoted(c.compiler),
                                  quoted(c.commit),
                                  std::to_string(c.threads),
                                  std::to_string(blocks),
                                  number(f.step),
                                  std::to_string(f.steps),
                                  number(static_cast<double>(f.iterations) / steps),
                                  number(static_cast<double>(f.factorizations) / steps),
                                  std::to_string(f.cuts),
                                  number(f.wall_time),
                                  number(1e6 * f.wall_time / (steps * blocks)),
                                  number(f.input_energy > 0 ? f.residual / f.input_energy : 0, "%.2e")};
    std::string line;
    for (const std::string& field : fields) line += (line.empty() ? "" : ",") + field;
    return line + "\n";
}

}  // namespace rockslope::bench
