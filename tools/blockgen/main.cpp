#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include "blockgen/cut/cut_blocks.hpp"
#include "blockgen/faces/enclosed_area.hpp"
#include "blockgen/input/domain.hpp"
#include "blockgen/mesh/block_file.hpp"
#include "blockgen/picture/block_picture.hpp"
#include "blockgen/picture/rose_picture.hpp"
#include "blockgen/picture/stereonet_picture.hpp"
#include "blockgen/report/geojson_text.hpp"
#include "blockgen/report/vtk_text.hpp"
#include "blockgen/sampling/sample_joints.hpp"
#include "common/base/atomic_file.hpp"
#include "common/base/output_error.hpp"
#include "fit_command.hpp"
#include "heap.hpp"
#include "options.hpp"
#include "provenance.hpp"
#include "support/standard_streams.hpp"

namespace rockslope::blockgen_tool {
namespace {

using namespace blockgen;

constexpr int done = 0, failed = 1, bad_input = 2;

ConfigTable read_config(const Options& options) {
    std::vector<std::string> overrides = options.overrides;
    if (options.seed) overrides.push_back("seed=" + std::to_string(*options.seed));
    return ConfigTable::from_file(options.model, overrides);
}

/// Colours of the first movement: warm for blocks that move, pale for blocks held by friction.
BlockLayer kinematic_layer(const KinematicReport& report) {
    BlockLayer layer;
    layer.title = "First movement";
    layer.entries = {{"falls", {0.78, 0.13, 0.13}},
                     {"slides", {0.93, 0.49, 0.19}},
                     {"held by friction", {0.98, 0.85, 0.45}},
                     {"removable, stable", {0.62, 0.80, 0.62}},
                     {"tapered", {0.64, 0.74, 0.86}}};
    layer.entry_of_block.assign(report.mode.size(), -1);
    for (const BlockIndex b : report.mode.indices()) {
        if (report.mode[b] == BlockMode::stable) layer.entry_of_block[b] = 3;
        if (report.mode[b] == BlockMode::tapered) layer.entry_of_block[b] = 4;
    }
    for (const KeyBlock& key : report.blocks)
        layer.entry_of_block[key.block] = key.mode == BlockMode::falling ? 0
                                          : key.factor_of_safety < 1     ? 1
                                                                         : 2;
    return layer;
}

std::vector<RoseSet> rose_sets(const CutReport& report) {
    std::vector<RoseSet> sets;
    for (const JointBalance& b : report.joints) sets.push_back({b.name, b.length_by_direction});
    return sets;
}

bool has_planes_in_space(const SlopeModel& model) {
    return std::any_of(model.joint_sets.begin(), model.joint_sets.end(),
                       [](const JointSet& set) { return !set.orientation.poles.empty(); });
}

Stereonet stereonet(const SlopeModel& model, const CutReport& report) {
    Stereonet net;
    for (const JointPlanes& of_set : report.planes) {
        StereonetSet set{of_set.name, {}, {of_set.mean.dip, of_set.mean.dip_direction}, of_set.k};
        for (const PlaneAngles& plane : of_set.planes) set.planes.push_back({plane.dip, plane.dip_direction});
        net.sets.push_back(std::move(set));
    }
    const auto has_planes = [&](const std::string& name) {
        return std::any_of(net.sets.begin(), net.sets.end(),
                           [&](const StereonetSet& set) { return set.name == name; });
    };
    for (const JointBalance& b : report.joints)
        if (!has_planes(b.name) && !(model.base && model.base->name == b.name))
            net.without_planes.push_back(b.name);
    net.section_azimuth = model.section ? model.section->azimuth : 0;
    return net;
}

void write_report(const std::filesystem::path& path, const CutReport& report) {
    write_file_atomically(path, path.extension() == ".txt" ? report_tables(report) : report_text(report));
}

void write_results(const Options& options, const SlopeModel& model, const std::vector<Trace>& traces,
                   const CutResult& result) {
    const PageStyle& style = options.picture_style;
    if (!options.picture.empty()) draw_blocks(result.mesh, {}, style).write(options.picture);
    if (!options.size_picture.empty()) draw_sizes(result.mesh, style).write(options.size_picture);
    if (!options.rose_picture.empty()) draw_rose(rose_sets(result.report), style).write(options.rose_picture);
    if (!options.stereonet_picture.empty())
        draw_stereonet(stereonet(model, result.report), style).write(options.stereonet_picture);
    if (!options.kinematic_picture.empty())
        draw_blocks(result.mesh, kinematic_layer(*result.report.kinematics), style)
            .write(options.kinematic_picture);
    if (!options.geojson.empty())
        write_file_atomically(options.geojson, geojson_text(result.mesh, system_urn(model)));
    if (!options.vtk.empty()) write_file_atomically(options.vtk, vtk_text(result.mesh, traces));
    if (!options.report.empty()) write_report(options.report, result.report);
    if (!options.depfile.empty()) write_file_atomically(options.depfile, make_rule(options, model));
    write_block_file(options.output, result.mesh, ThreadPool(options.threads));
}

int print(const std::string& text) {
    if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return done;
    std::fputs("blockgen: the standard output cannot be written\n", stderr);
    return failed;
}

int run(const Options& options) {
    if (!options.text.empty()) return print(options.text);
    const auto start = std::chrono::steady_clock::now();
    const ReadLog log;
    const ConfigTable config = read_config(options);
    const SlopeModel model = read_slope_model(config, blockgen::enclosed_area);
    if (options.print_config) return print(config.effective_text());
    check_outputs(options, model);
    if (!options.kinematic_picture.empty() && !model.kinematics)
        config.fail("kinematics", "--kinematic-picture without [kinematics]",
                    "[kinematics] with a friction_angle");
    if (!options.stereonet_picture.empty() && !has_planes_in_space(model))
        config.fail("joint_set", "--stereonet-picture without planes in space",
                    "a [[joint_set]] with dip and dip_direction, orientations or orientation_file");

    const std::vector<Trace> traces = all_traces(model, options.max_blocks);
    CutResult result = cut_blocks(model, traces,
                                  {.max_blocks = options.max_blocks,
                                   .verify = options.verify,
                                   .threads = options.threads,
                                   .full_report = !options.report.empty() || !options.rose_picture.empty() ||
                                                  !options.stereonet_picture.empty()});
    result.mesh.provenance = provenance(model, config, log);
    for (const std::string& warning : result.report.warnings)
        std::fprintf(stderr, "warning: %s\n", warning.c_str());
    write_results(options, model, traces, result);

    if (const MergeReport& merges = result.report.merges; merges.merged_blocks > 0)
        std::printf("%zu small blocks merged with their neighbours, %.3g m2 in all, the largest %.3g m2\n",
                    merges.merged_blocks, merges.merged_area, merges.largest_merged);

    if (result.report.slivers > 0)
        std::printf(
            "%zu sliver%s with 4 pi area / perimeter^2 below %g; [small_blocks] with policy = \"merge\" "
            "removes them\n",
            result.report.slivers, result.report.slivers == 1 ? "" : "s", model.small_blocks.below_roundness);

    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%s: %zu blocks, D50 %.3g m2, %.3g s%s\n", options.output.c_str(), result.report.blocks,
                result.report.free_sizes.area > 0 ? result.report.free_sizes.d50 : result.report.sizes.d50,
                seconds.count(), options.verify ? ", verified" : "");
    return done;
}

int run_in_memory(const Options& options) {
    try {
        return run(options);
    } catch (const std::bad_alloc&) {
        throw std::runtime_error("out of memory: a limit below that of --max-blocks, " +
                                 std::to_string(options.max_blocks) +
                                 ", refuses so many joints before they are cut");
    }
}

/// Does what the arguments ask for; prints why it failed. @return the exit code.
int act_on_arguments(int argc, char** argv) {
    try {
        if (argc > 1 && std::string(argv[1]) == "fit") return run_fit({argv + 2, argv + argc});
        return run_in_memory(parse_options(argc, argv));
    } catch (const UsageError& error) {
        std::fprintf(stderr, "blockgen: %s\n", error.what());
        return bad_input;
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return bad_input;
    } catch (const OutputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return bad_input;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "blockgen: %s\n", error.what());
        return failed;
    }
}

}  // namespace
}  // namespace rockslope::blockgen_tool

using namespace rockslope;
using namespace rockslope::blockgen_tool;

int main(int argc, char** argv) {
    use_large_pages();
    return tool_support::run_program("blockgen", [&] { return act_on_arguments(argc, argv); });
}
