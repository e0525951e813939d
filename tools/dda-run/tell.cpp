#include "tell.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>

#include "dda/analysis/deepest_contact.hpp"
#include "dda/analysis/energy_watch.hpp"
#include "dda/model/glue.hpp"
#include "dda/monitor/close_reversals.hpp"
#include "dda/monitor/plausibility.hpp"
#include "dda/monitor/point_motion.hpp"
#include "dda/monitor/spring_resolution.hpp"
#include "dda/terms/contact_damping.hpp"

namespace rockslope {

namespace fs = std::filesystem;

namespace {

/// "4.7 GB" or "35 MB".
std::string memory_text(double bytes) {
    char text[32];
    const bool many = bytes >= 1e9;
    const double amount = bytes / (many ? 1e9 : 1e6);
    std::snprintf(text, sizeof text, amount < 10 ? "%.2g %s" : "%.0f %s", amount, many ? "GB" : "MB");
    return text;
}

void print_plan(const dda::RunInput& input, const fs::path& folder) {
    const double frames = dda::estimated_bytes(input.model, input.stages, input.output);
    const double settling = dda::max_static_frame_bytes(input.model, input.stages, input.output);
    const std::string more =
        settling > 0 ? ", up to " + memory_text(settling) + " more while static stages settle," : "";
    const std::size_t stages = input.stages.size();
    std::fprintf(stderr, "dda-run: %d blocks, %zu stage%s, about %s of frames%s into %s\n",
                 input.model.block_count(), stages, stages == 1 ? "" : "s", memory_text(frames).c_str(),
                 more.c_str(), folder.string().c_str());
}

/// Reports the excavations of stages that this run does not have; their blocks stay.
void warn_of_unreached_excavations(const dda::RunInput& input, Warnings& warnings) {
    for (const dda::Excavation& e : input.model.excavations)
        if (static_cast<std::size_t>(e.stage) > input.stages.size())
            warnings.tell("excavation '%s' is not removed: its stage is %d, the run has %zu stages",
                          e.name.c_str(), e.stage, input.stages.size());
}

/// Tells of blocks that cannot bend with the body that they are glued to.
void warn_of_glued_polygons(const dda::Model& model, Warnings& warnings) {
    const std::optional<dda::GluedPolygons> glued = dda::glued_polygons(model);
    if (!glued) return;
    const dda::Vec2 at = model.vertices[model.topology.block_corners[glued->first]] + model.origin;
    warnings.tell(
        "%d blocks of more than three corners are glued, the first is block %d with a corner "
        "at (%g, %g), joint material %s: a body of them is many times too stiff in bending; cut it "
        "into triangles",
        glued->blocks, glued->first.value(), at.x(), at.y(),
        model.joint_material_at(glued->joint_material).name.c_str());
}

/// Tells of a contact_damping that the steps are too long for.
void warn_of_ineffective_damping(const dda::RunInput& input, Warnings& warnings) {
    const auto found = dda::ineffective_damping(input.model, input.stages);
    if (!found) return;
    const dda::JointMaterial& material = input.model.joint_material_at(found->joint_material);
    const dda::Stage& stage = input.stages[found->stage];
    warnings.tell(
        "contact_damping %g of joint material '%s' has no effect in stage '%s': steps of %g s "
        "damp impacts more (omega dt is %.3g for a block of median mass); see docs/guide/impacts.md",
        material.contact_damping, material.name.c_str(), stage.name.c_str(), stage.control.step,
        found->frequency_step);
}

/// Tells of shear springs whose swing the steps damp.
void warn_of_lost_swings(const dda::RunInput& input, Warnings& warnings) {
    for (const dda::SpringResolution& found : dda::spring_resolutions(input.model, input.stages)) {
        if (!dda::loses_swing(found)) continue;
        const dda::Stage& stage = input.stages[found.stage];
        warnings.tell(
            "stage '%s': a swing of the shear spring of joint material '%s' loses %.2g %% in each "
            "period, of %.0f steps; slips may be too small. Steps of %.2g s lose %g %%",
            stage.name.c_str(), input.model.joint_material_at(found.joint_material).name.c_str(),
            100 * found.lost_per_period, found.shear_period_steps, dda::step_that_keeps_swing(found, stage),
            100 * dda::largest_lost_per_period);
    }
}

/// Prints the factor of safety of a strength reduction: between the largest stable and the smallest failing
/// reduction factor.
void print_factor_of_safety(const std::vector<dda::ReductionTrial>& trials) {
    double stands = 0;
    double fails = std::numeric_limits<double>::infinity();
    for (const dda::ReductionTrial& trial : trials) {
        if (trial.stands)
            stands = std::max(stands, trial.factor);
        else
            fails = std::min(fails, trial.factor);
    }
    if (trials.empty()) return;
    if (stands == 0)
        std::fprintf(stderr, "dda-run: factor of safety below %.4g\n", fails);
    else if (std::isinf(fails))
        std::fprintf(stderr, "dda-run: factor of safety above %.4g\n", stands);
    else
        std::fprintf(stderr, "dda-run: factor of safety %.4g, between %.4g (stands) and %.4g (fails)\n",
                     std::sqrt(stands * fails), stands, fails);
}

/// Tells of energy that came from nowhere.
void warn_of_energy(const dda::Model& model, const dda::Energy& energy, Warnings& warnings) {
    for (const std::string& line : dda::energy_from_nowhere(model, energy))
        warnings.tell("%s. Displacements may be wrong by more than that share", line.c_str());
}

/// Says which blocks still moved when a static stage ended.
void warn_of_left_moving(const std::vector<dda::LeftMoving>& left, const std::vector<dda::Stage>& stages,
                         Warnings& warnings) {
    for (std::size_t k = 0; k < stages.size(); ++k) {
        int count = 0;
        double share = 0;
        const dda::LeftMoving* farthest = nullptr;
        for (const dda::LeftMoving& block : left) {
            if (static_cast<std::size_t>(block.stage) != k) continue;
            ++count;
            share += block.share;
            if (!farthest || block.displacement > farthest->displacement) farthest = &block;
        }
        if (!farthest) continue;
        warnings.tell(
            "stage '%s' is at rest but for %d small block%s, %.2g of the mass; block %d at (%.6g, "
            "%.6g) has moved farthest, %.3g m. %s; see moving_at_rest in summary.json",
            stages[k].name.c_str(), count, count == 1 ? "" : "s", share, farthest->block.value(),
            farthest->centroid.x(), farthest->centroid.y(), farthest->displacement,
            stages[k].remove_moving ? "Removed" : "Kept");
    }
}

/// Tells of a block that is inside another one.
void warn_of_deep_contact(const dda::DeepestContact& deepest, Warnings& warnings) {
    if (!(deepest.share > dda::deep_share)) return;
    warnings.tell(
        "block %d was inside block %d by %.3g m at t = %.6g s, %.2g %% of the smaller one; a stiffer contact "
        "keeps it out, or a penetration_tolerance where the joint has no stiffness of its own",
        deepest.corner_block.value(), deepest.edge_block.value(), deepest.depth, deepest.time,
        100 * deepest.share);
}

/// Tells of the blocks that have left the ground.
void warn_of_lost_blocks(const dda::Model& model, const std::vector<dda::LostBlock>& lost,
                         Warnings& warnings) {
    if (lost.empty()) return;
    const dda::LostBlock& first = lost.front();
    const dda::Vec2 at = first.centroid + model.origin;
    warnings.tell(
        "%zu %s left the ground, below all fixed and prescribed blocks, and %s; the first is block %d at "
        "t = %.6g s and (%.6g, %.6g)",
        lost.size(), lost.size() == 1 ? "block has" : "blocks have",
        model.removes_lost_blocks ? "was removed there" : "falls on", first.block.value(), first.time, at.x(),
        at.y());
}

/// Says which points still move at the end of a dynamic stage.
void warn_of_still_moving(const dda::Model& model, const dda::State& state, const dda::Stage& last,
                          const dda::Results& results, Warnings& warnings) {
    constexpr double at_rest = 0.01;  // m/s
    if (last.is_static()) return;
    const dda::PointMotion from = results.reference()
                                      ? dda::motion_of(model, state, results.points()[*results.reference()])
                                      : dda::PointMotion{};
    for (const dda::TrackedPoint& point : results.points()) {
        const double speed = (dda::motion_of(model, state, point).velocity - from.velocity).norm();
        if (point.material_point.exists() && speed > at_rest)
            warnings.tell(
                "'%s' still moves at %.2g m/s at the end; a longer stage shows where it comes to rest",
                point.name.c_str(), speed);
    }
}

/// Says how many bonds static stages could not hold.
void print_broken_bonds(const dda::BrokenBonds& broken) {
    if (broken.events == 0) return;
    std::fprintf(stderr,
                 "dda-run: the bonds of %lld contacts could not be held at rest and broke, the worst first "
                 "(events: %lld)\n",
                 static_cast<long long>(broken.contacts), static_cast<long long>(broken.events));
}

/// Says how many bonds hold a slope at rest by all of their strength.
void warn_of_strained_bonds(const dda::StrainedBonds& strained, Warnings& warnings) {
    if (strained.contacts == 0) return;
    warnings.tell(
        "%lld of %lld bonded contacts bear all of their strength at rest, and a dynamic stage may break "
        "them; one without shaking shows whether the slope stands",
        static_cast<long long>(strained.contacts), static_cast<long long>(strained.of));
}

/// Says how many reversals hang on `min_slip`.
void warn_of_close_reversals(const dda::CloseReversals& close, Warnings& warnings) {
    if (close.counted + close.not_counted == 0) return;
    warnings.tell(
        "%lld reversals of slip that counted and %lld that did not are within a factor of %g "
        "of min_slip; the wear depends on it. See reversals_close_to_min_slip in summary.json",
        static_cast<long long>(close.counted), static_cast<long long>(close.not_counted),
        dda::CloseReversals::factor);
}

}  // namespace

void tell_of_plan(const dda::RunInput& input, const fs::path& folder, Warnings& warnings) {
    print_plan(input, folder);
    warn_of_unreached_excavations(input, warnings);
    warn_of_glued_polygons(input.model, warnings);
    warn_of_ineffective_damping(input, warnings);
    warn_of_lost_swings(input, warnings);
    for (const std::string& warning : dda::implausible(input.model, input.stages))
        warnings.tell("%s", warning.c_str());
}

void tell_of_results(const dda::RunInput& input, const dda::State& state, const dda::RunOutcome& outcome,
                     const dda::Results& results, const std::vector<dda::PlaneSlip>& slips,
                     Warnings& warnings) {
    std::fputs(dda::outcome_table(input.model, state, results, slips).c_str(), stdout);
    print_factor_of_safety(results.state().trials);
    warn_of_left_moving(results.state().left_moving, input.stages, warnings);
    warn_of_lost_blocks(input.model, state.lost_blocks, warnings);
    warn_of_deep_contact(state.deepest_contact, warnings);
    if (outcome.status == dda::RunStatus::completed)
        warn_of_still_moving(input.model, state, input.stages.back(), results, warnings);
    print_broken_bonds(state.broken_bonds);
    warn_of_strained_bonds(state.strained_bonds, warnings);
    if (outcome.status != dda::RunStatus::energy_created) warn_of_energy(input.model, state.energy, warnings);
    warn_of_close_reversals(dda::with_present(results.state().close_reversals, input.model, state), warnings);
}

void tell_of_end(const dda::RunOutcome& outcome, const dda::State& state, double wall_time,
                 const fs::path& folder) {
    const char* where = folder.c_str();
    if (outcome.status == dda::RunStatus::completed)
        std::fprintf(stderr, "dda-run: done, %lld steps to t = %.6g s in %.3g s; results in %s\n",
                     static_cast<long long>(state.step_count), state.time, wall_time, where);
    else if (outcome.status == dda::RunStatus::stopped)
        std::fprintf(stderr, "dda-run: stopped at t = %.6g s; --resume continues from the checkpoint in %s\n",
                     state.time, where);
    else
        std::fprintf(stderr, "dda-run: %s; results so far are in %s\n", outcome.message.c_str(), where);
}

}  // namespace rockslope
