#include "dda/input/read_run.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "blockgen/mesh/block_file.hpp"
#include "blockgen/mesh/check_mesh.hpp"
#include "blockgen/mesh/find_overlap.hpp"
#include "common/base/text.hpp"
#include "common/config/config_table.hpp"
#include "dda/input/read_loads.hpp"
#include "dda/input/read_materials.hpp"
#include "dda/input/read_mesh.hpp"
#include "dda/input/read_reference.hpp"
#include "dda/input/read_stages.hpp"

namespace rockslope::dda {

namespace {

/// Default normal penalty over the largest Young's modulus. A large value keeps the penetration small against
/// the strain of the blocks; a far larger one costs step size. Dimensionless (E per metre), usually 1 to 100.
constexpr double penalty_over_modulus = 10;

double largest_modulus(const Model& model) {
    double largest = 0;
    for (const BlockMaterial& material : model.block_materials)
        largest = std::max(largest, material.youngs_modulus);
    return largest;
}

JointMaterialIndex read_default_joint_material(const ConfigTable& analysis, const Model& model) {
    std::vector<std::string> names;
    for (const JointMaterial& material : model.joint_materials) names.push_back(material.name);
    const std::string name = analysis.choice("default_joint_material", names, names.front());
    return std::find(names.begin(), names.end(), name) - names.begin();
}

StraightCorners read_straight_corners(const ConfigTable& analysis) {
    return analysis.choice("straight_corners", {"keep", "drop"}, "keep") == "keep" ? StraightCorners::keep
                                                                                   : StraightCorners::drop;
}

/// @throws InputError if contacts that do not give way are to be damped.
void check_contact_damping(const ConfigTable& analysis, const Model& model) {
    for (const JointMaterialIndex k : model.joint_materials.indices()) {
        const JointMaterial& material = model.joint_material_at(k);
        if (material.contact_damping > 0 && model.is_augmented(k))
            analysis.fail("penetration_tolerance",
                          "'penetration_tolerance' makes contacts rigid, and 'contact_damping' of "
                          "[joint_material." +
                              material.name + "] damps contacts that give way",
                          "one of them, or 'normal_stiffness' in the joint material");
    }
}

void read_analysis(const ConfigTable& analysis, Model& model) {
    model.plane =
        analysis.choice("plane", {"strain", "stress"}, "strain") == "strain" ? Plane::strain : Plane::stress;
    const std::array<double, 2> gravity = analysis.pair("gravity", Dimension::acceleration, {0, -9.81});
    model.gravity = {gravity[0], gravity[1]};
    model.strength_reduction =
        positive(analysis, "strength_reduction", Dimension::none, model.strength_reduction);
    model.normal_penalty = positive(analysis, "normal_penalty", Dimension::stiffness,
                                    penalty_over_modulus * largest_modulus(model));
    model.penetration_tolerance = not_negative(analysis, "penetration_tolerance", Dimension::length, 0);
    check_contact_damping(analysis, model);
    model.shear_penalty = positive(analysis, "shear_penalty", Dimension::stiffness, model.normal_penalty);
    model.fixed_point_penalty =
        positive(analysis, "fixed_point_penalty", Dimension::stiffness, model.normal_penalty);
    model.default_joint_material = read_default_joint_material(analysis, model);
    model.removes_lost_blocks = analysis.choice("lost_blocks", {"keep", "remove"}, "keep") == "remove";
    const std::string solver =
        analysis.choice("solver", {"multifrontal", "refined", "simplicial"}, "multifrontal");
    model.solver = solver == "simplicial" ? SolverKind::simplicial
                   : solver == "refined"  ? SolverKind::refined
                                          : SolverKind::multifrontal;
}

int count_up_to_a_million(const ConfigTable& output, std::string_view key, int fallback) {
    const std::int64_t value = output.integer(key, fallback);
    output.checked(
        key, static_cast<double>(value), [](double v) { return v >= 0 && v <= 1e6; },
        "a whole number from 0 to 1000000");
    return value;
}

/// s; keeps the number of intervals in a stage within an integer.
constexpr double shortest_history_interval = 1e-9;

bool is_stem(const std::string& name) {
    constexpr std::size_t longest = 200;  // leaves room for extensions in the 255 bytes of a file name
    const auto is_forbidden = [](char c) {
        return c == '/' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    };
    return !name.empty() && name.size() <= longest && name.front() != '.' &&
           std::none_of(name.begin(), name.end(), is_forbidden);
}

OutputSpec read_output(const ConfigTable& output, const std::filesystem::path& run_file, const Model& model) {
    OutputSpec spec;
    spec.name = output.string("name", run_file.stem().string());
    if (!is_stem(spec.name))
        output.fail(
            "name", "'name' in [output] is \"" + spec.name + "\"",
            "the stem of a file name, at most 200 bytes without '/', a dot in front or control characters");
    spec.frames = count_up_to_a_million(output, "frames", spec.frames);
    spec.joint_frames = output.boolean("joint_frames", spec.joint_frames);
    spec.step_log = output.boolean("step_log", spec.step_log);
    spec.static_frame_interval =
        count_up_to_a_million(output, "static_frame_interval", spec.static_frame_interval);
    spec.history_interval = output.checked(
        "history_interval", output.number("history_interval", Dimension::time, spec.history_interval),
        [](double v) { return v == 0 || v >= shortest_history_interval; },
        "0, for every step, or a time of 1e-9 s or more");
    spec.relative_to = read_reference(output, model);
    spec.slip_threshold = positive(output, "slip_threshold", Dimension::length, spec.slip_threshold);
    spec.save_stages = output.boolean("save_stages", spec.save_stages);
    spec.checkpoint_interval =
        positive(output, "checkpoint_interval", Dimension::time, spec.checkpoint_interval);
    return spec;
}

std::vector<std::string> with_block_file(const RunReadOptions& options) {
    std::vector<std::string> overrides = options.overrides;
    if (options.blocks) {
        std::string text = "blocks=\"";
        for (const char c : options.blocks->string())
            text += (c == '"' || c == '\\') ? std::string("\\") + c : std::string(1, c);
        overrides.push_back(text + '"');
    }
    return overrides;
}

/// Checks that the excavations leave a free block in every stage.
void check_excavations(const Model& model, int stages, const std::filesystem::path& block_file) {
    PerBlock<Motion> motion = model.motion;
    for (int stage = 1; stage <= stages; ++stage)
        for (const Excavation& excavation : model.excavations) {
            if (excavation.stage != stage) continue;
            for (const BlockIndex block : excavation.blocks) motion[block] = Motion::removed;
            if (std::find(motion.begin(), motion.end(), Motion::free) == motion.end())
                throw InputError({block_file.string()},
                                 "excavation '" + excavation.name +
                                     "' leaves no block that is free to move in stage " +
                                     std::to_string(stage),
                                 "at least one free block in every stage");
        }
}

/// @throws InputError with both blocks and the place, where two blocks overlap.
void check_overlaps(const blockgen::BlockMesh& mesh, const std::filesystem::path& block_file) {
    const std::optional<blockgen::Overlap> found = blockgen::find_overlap(mesh);
    if (!found) return;
    throw InputError({block_file.string()},
                     "blocks " + std::to_string(found->first.value()) + " and " +
                         std::to_string(found->second.value()) + " overlap at (" +
                         shortest_text(found->at.x) + ", " + shortest_text(found->at.y) + ")",
                     "blocks that touch at most");
}

}  // namespace

RunInput read_run(const std::filesystem::path& run_file, const RunReadOptions& options) {
    const ReadLog log;
    const ConfigTable run = ConfigTable::from_file(run_file, with_block_file(options));
    RunInput input;
    const std::filesystem::path block_file = run.file_path("blocks");
    input.files = {run_file, block_file};

    Model& model = input.model;
    model.block_materials = read_block_materials(run);
    model.joint_materials = read_joint_materials(run);
    const std::vector<BoltMaterial> bolt_materials = read_bolt_materials(run);
    const ConfigTable analysis = run.table_or_empty("analysis");
    read_analysis(analysis, model);
    const blockgen::BlockMesh mesh = blockgen::read_block_file(block_file);
    if (mesh.block_count() == 0) throw InputError({block_file.string()}, "has no block", "one block or more");
    blockgen::check_mesh(mesh, block_file.string());
    check_overlaps(mesh, block_file);
    add_mesh(mesh, block_file.string(), bolt_materials, read_straight_corners(analysis), model);
    if (std::find(model.motion.begin(), model.motion.end(), Motion::free) == model.motion.end())
        throw InputError({block_file.string()}, "every block is fixed or prescribed",
                         "a block that is free to move");
    read_loads(run, mesh.water_table, model, input.files);
    read_boundaries(run, model);
    read_measured_joints(run, model);
    read_measured_regions(run, model);
    input.stages = read_stages(run, model, input.files);
    check_excavations(model, input.stages.size(), block_file);
    input.output = read_output(run.table_or_empty("output"), run_file, model);
    run.finish();
    input.digests = log.files();
    input.fingerprint =
        run.effective_text([&](const std::filesystem::path& file) { return log.digest_of(file); });
    input.effective = "# The effective model: what was read, with every default.\n" +
                      run.effective_text(options.echo_folder);
    return input;
}

}  // namespace rockslope::dda
