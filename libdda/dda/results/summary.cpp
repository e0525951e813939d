#include "dda/results/summary.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "dda/analysis/energy_watch.hpp"
#include "dda/monitor/farthest_block.hpp"
#include "dda/monitor/motion_measures.hpp"
#include "dda/monitor/spring_resolution.hpp"
#include "dda/results/block_table.hpp"

namespace rockslope::dda {

using Json = nlohmann::ordered_json;

namespace {

const char* status_name(RunStatus status) {
    switch (status) {
        case RunStatus::completed:
            return "completed";
        case RunStatus::not_converged:
            return "not converged";
        case RunStatus::not_settled:
            return "not settled";
        case RunStatus::energy_created:
            return "energy created";
        case RunStatus::not_written:
            return "not written";
        case RunStatus::collapsed:
            return "collapsed";
        default:
            return "stopped";
    }
}

Json pair(const Vec2& v) {
    return Json::array({v.x(), v.y()});
}

/// Ratio of a peak acceleration to the reference's; null without a reference or if that is zero.
Json over_reference(double peak, const Results& results) {
    if (!results.reference()) return nullptr;
    const double base = results.state().peaks[*results.reference()].smooth_acceleration;
    return base > 0 ? Json(peak / base) : Json(nullptr);
}

Json peaks_json(const Results& results, const Model& model, const State& state) {
    const PointMotion from =
        results.reference() ? motion_of(model, state, results.points()[*results.reference()]) : PointMotion{};
    Json points = Json::array();
    for (std::size_t i = 0; i < results.points().size(); ++i) {
        const TrackedPoint& point = results.points()[i];
        const Peaks& peaks = results.state().peaks[i];
        const PointMotion motion = motion_of(model, state, point);
        points.push_back({{"name", point.name},
                          {"kind", point.material_point.exists() ? "measured point" : "prescribed block"},
                          {"final_displacement", pair(motion.displacement)},
                          {"peak_displacement", peaks.displacement},
                          {"peak_displacement_time", peaks.displacement_time},
                          {"peak_velocity", peaks.velocity},
                          {"peak_velocity_time", peaks.velocity_time},
                          {"peak_acceleration", peaks.acceleration},
                          {"peak_acceleration_time", peaks.acceleration_time},
                          {"permanent_displacement", pair(motion.displacement - from.displacement)},
                          {"relative_speed", (motion.velocity - from.velocity).norm()},
                          {"peak_relative_displacement", peaks.relative},
                          {"peak_relative_displacement_time", peaks.relative_time},
                          {"peak_smooth_acceleration", peaks.smooth_acceleration},
                          {"amplification", over_reference(peaks.smooth_acceleration, results)}});
    }
    return points;
}

Json regions_json(const Results& results, const Model& model, const State& state) {
    const Vec2 from = results.reference()
                          ? motion_of(model, state, results.points()[*results.reference()]).displacement
                          : Vec2(Vec2::Zero());
    Json regions = Json::array();
    for (std::size_t i = 0; i < model.measured_regions.size(); ++i) {
        const MeasuredRegion& region = model.measured_regions[i];
        const RegionDisplacement end = displacement_of(state, region, from);
        const RegionPeaks& peaks = results.state().regions[i];
        regions.push_back({{"name", region.name},
                           {"blocks", region.blocks.size()},
                           {"mean_displacement", end.mean},
                           {"largest_displacement", end.largest},
                           {"peak_mean_displacement", peaks.mean},
                           {"peak_mean_displacement_time", peaks.mean_time},
                           {"peak_largest_displacement", peaks.largest},
                           {"peak_largest_displacement_time", peaks.largest_time}});
    }
    return regions;
}

/// The block that is farthest at the end, and the one that was at the peak of the dynamic stages.
Json farthest_json(const Results& results, const Model& model, const State& state) {
    const Vec2 from = results.reference()
                          ? motion_of(model, state, results.points()[*results.reference()]).displacement
                          : Vec2(Vec2::Zero());
    const auto farthest = farthest_block(model, state, from);
    if (!farthest) return nullptr;
    Json json = {{"block", farthest->block.value()},
                 {"displacement", farthest->displacement},
                 {"centroid", pair(state.blocks.centroid(farthest->block) + model.origin)}};
    if (const auto& peak = results.state().farthest)
        json.update({{"peak_block", peak->block.value()},
                     {"peak_displacement", peak->displacement},
                     {"peak_displacement_time", peak->time}});
    return json;
}

Json contact_counts(const State& state) {
    std::array<int, 3> counts{};
    for (const Contact& contact : state.contacts.contacts) ++counts[static_cast<std::size_t>(contact.state)];
    return {{"open", counts[0]}, {"sliding", counts[1]}, {"locked", counts[2]}};
}

/// The number of blocks that slipped, and the first of them.
Json slips_json(const std::vector<FirstSlip>& slips) {
    const auto slipped = [](const FirstSlip& slip) { return slip.has_slipped(); };
    const auto count = std::count_if(slips.begin(), slips.end(), slipped);
    if (count == 0) return Json::object({{"blocks", 0}});
    const auto first = std::min_element(slips.begin(), slips.end(), [&](const auto& a, const auto& b) {
        return slipped(a) && (!slipped(b) || a.dynamic_time < b.dynamic_time);
    });
    return {{"blocks", count},
            {"first", first - slips.begin()},
            {"first_time", first->time},
            {"first_time_of_shaking", first->dynamic_time}};
}

Json planes_json(const std::vector<PlaneSlip>& slips) {
    Json planes = Json::array();
    for (const PlaneSlip& slip : slips) {
        planes.push_back({{"block", slip.plane.block.value()},
                          {"base", slip.plane.base.value()},
                          {"dip", slip.plane.dip},
                          {"yield_coefficient", slip.yield},
                          {"newmark_slip", slip.newmark},
                          {"slip", slip.simulated}});
        if (!slip.ignored.empty()) planes.back()["newmark_ignores"] = slip.ignored;
    }
    return planes;
}

Json energy_json(const Energy& e) {
    return {{"kinetic", e.kinetic},
            {"strain", e.strain},
            {"contact", e.contact},
            {"constraint", e.constraint},
            {"gravity", e.gravity},
            {"friction_loss", e.friction_loss},
            {"damping_loss", e.damping_loss},
            {"contact_damping_loss", e.contact_damping_loss},
            {"numerical_loss", e.numerical_loss},
            {"released", e.released},
            {"boundary_loss", e.boundary_loss},
            {"excavated", e.excavated},
            {"external_work", e.external_work},
            {"residual", e.residual()},
            {"friction_returned", e.friction_returned},
            {"turned_over", turned_over(e)}};
}

Json springs_json(const Model& model, const std::vector<Stage>& stages) {
    Json list = Json::array();
    for (const SpringResolution& r : spring_resolutions(model, stages))
        list.push_back({{"stage", stages[r.stage].name},
                        {"joint_material", model.joint_material_at(r.joint_material).name},
                        {"shear_period_steps", r.shear_period_steps},
                        {"normal_period_steps", r.normal_period_steps},
                        {"swing", r.swing},
                        {"lost_per_period", r.lost_per_period}});
    return list;
}

Json left_moving_json(const std::vector<LeftMoving>& left, const Model& model,
                      const std::vector<Stage>& stages) {
    Json list = Json::array();
    for (const LeftMoving& l : left) {
        const Stage& stage = stages[static_cast<std::size_t>(l.stage)];
        list.push_back({{"stage", stage.name},
                        {"block", l.block.value()},
                        {"centroid", pair(l.centroid)},
                        {"mass", l.mass},
                        {"share_of_mass", l.share},
                        {"displacement", l.displacement},
                        {"removed", stage.remove_moving}});
        if (!model.block_name[l.block].empty()) list.back()["name"] = model.block_name[l.block];
    }
    return list;
}

Json deepest_contact_json(const DeepestContact& deepest) {
    if (!deepest.corner_block.exists()) return nullptr;
    return {{"depth", deepest.depth},
            {"share_of_block", deepest.share},
            {"time", deepest.time},
            {"blocks", {deepest.corner_block.value(), deepest.edge_block.value()}}};
}

Json lost_blocks_json(const std::vector<LostBlock>& lost, const Model& model) {
    Json list = Json::array();
    for (const LostBlock& l : lost) {
        list.push_back({{"block", l.block.value()},
                        {"time", l.time},
                        {"centroid", pair(l.centroid + model.origin)},
                        {"removed", model.removes_lost_blocks}});
        if (!model.block_name[l.block].empty()) list.back()["name"] = model.block_name[l.block];
    }
    return list;
}

Json close_reversals_json(const Model& model, const CloseReversals& close) {
    Json list = Json::array();
    for (const CloseReversal& reversal : close.nearest) {
        const JointCounterSlip& joint = reversal.joint;
        list.push_back({{"time", reversal.time},
                        {"blocks", {joint.first.value(), joint.second.value()}},
                        {"at", pair(joint.at + model.origin)},
                        {"joint_material", model.joint_material_at(joint.joint_material).name},
                        {"min_slip", joint.slip.least},
                        {"slip", joint.slip.amount},
                        {"counted", joint.slip.counted},
                        {"ended", reversal.ended}});
    }
    return {{"factor", CloseReversals::factor},
            {"counted", close.counted},
            {"not_counted", close.not_counted},
            {"nearest", list}};
}

/// The bracket of the factor of safety, null where no trial stood or none failed, and the trials.
Json factor_of_safety(const std::vector<ReductionTrial>& trials) {
    Json stands, fails;
    Json list = Json::array();
    for (const ReductionTrial& trial : trials) {
        Json& bound = trial.stands ? stands : fails;
        const bool tighter = bound.is_null() || (trial.stands ? trial.factor > bound.get<double>()
                                                              : trial.factor < bound.get<double>());
        if (tighter) bound = trial.factor;
        list.push_back({{"factor", trial.factor},
                        {"stands", trial.stands},
                        {"steps", trial.steps},
                        {"unbalanced_force", trial.unbalanced_force},
                        {"displacement", trial.displacement}});
    }
    return {{"stands", stands}, {"fails", fails}, {"trials", list}};
}

Json contact_json(const Model& model, const Contact& contact) {
    return {{"corner_block", contact.corner_block.value()},
            {"edge_block", contact.edge_block.value()},
            {"at", pair(contact.point + model.origin)},
            {"joint_material", model.joint_material_at(contact.joint_material).name},
            {"normal_force", contact.normal_force},
            {"shear_force", contact.shear_force},
            {"gap", contact.gap}};
}

Json motions_json(const std::vector<Stage>& stages) {
    Json list = Json::array();
    for (const MotionMeasures& motion : motion_measures(stages)) {
        const record::RecordMeasures& m = motion.measures;
        Json spectrum = Json::array();
        for (const record::SpectralOrdinate& ordinate : motion.spectrum)
            spectrum.push_back(
                {{"period", ordinate.period}, {"acceleration", ordinate.absolute_acceleration}});
        list.push_back({{"stage", motion.stage},
                        {"block", motion.block},
                        {"axis", std::string(1, motion.axis)},
                        {"peak_acceleration", m.peak_acceleration},
                        {"peak_velocity", m.peak_velocity},
                        {"peak_displacement", m.peak_displacement},
                        {"arias_intensity", m.arias_intensity},
                        {"significant_duration", m.significant_duration},
                        {"cumulative_absolute_velocity", m.cumulative_absolute_velocity},
                        {"mean_period", m.mean_period},
                        {"spectral_acceleration", spectrum}});
    }
    return list;
}

/// Where the same input gives the same results, byte for byte.
std::string same_bytes_on(bool fused) {
#if defined(__x86_64__)
    if (fused) return "every x86-64-v3 processor";
#endif
    return fused ? "processors of this architecture" : "x86-64 processors without fused multiply-adds";
}

void add_provenance(const Provenance& provenance, Json& json) {
    json["version"] = provenance.version;
    json["commit"] = provenance.commit;
    json["kernel"] = provenance.kernel;
    json["same_bytes_on"] = same_bytes_on(provenance.fused) + ", with any number of threads";
    json["displacements"] =
        "one sample: where blocks slide or fall, a change in the last digit moves them elsewhere, by a fifth "
        "or by metres; a study with replicates gives the distribution";
    json["threads"] = provenance.threads;
    json["fingerprint"] = provenance.fingerprint;
    json["overrides"] = provenance.overrides;
    if (provenance.saved_state)
        json["saved_state"] = {{"file", provenance.saved_state->path.string()},
                               {"sha256", provenance.saved_state->sha256}};
    json["inputs"] = Json::array();
    for (const InputFile& input : provenance.inputs)
        json["inputs"].push_back({{"file", input.path.string()}, {"sha256", input.sha256}});
    json["warnings"] = provenance.warnings;
}

Json collapse_json(const Collapse& collapse) {
    Json json = {{"block", collapse.block.value()},
                 {"at", pair(collapse.at)},
                 {"displacement", collapse.displacement},
                 {"limit", collapse.limit},
                 {"time", collapse.time}};
    if (!collapse.point.empty()) json["point"] = collapse.point;
    return json;
}

}  // namespace

std::string summary_text(const Model& model, const std::vector<Stage>& stages, const State& state,
                         const RunOutcome& outcome, const Results& results, const Provenance& provenance) {
    Json json;
    json["status"] = status_name(outcome.status);
    json["message"] = outcome.message;
    if (outcome.worst_contact) json["worst_contact"] = contact_json(model, *outcome.worst_contact);
    if (outcome.collapse) json["collapse"] = collapse_json(*outcome.collapse);
    json["stage"] = stages[results.state().stage].name;
    json["time"] = state.time;
    json["steps"] = state.step_count;
    json["wall_time"] = results.wall_time();
    json["blocks"] = model.block_count();
    json["contacts"] = contact_counts(state);
    json["fallbacks"] = results.state().fallbacks;
    json["largest_dilation_left"] = results.state().remaining_dilation;
    json["farthest_block"] = farthest_json(results, model, state);
    if (results.reference()) json["reference"] = results.points()[*results.reference()].name;
    json["points"] = peaks_json(results, model, state);
    if (!model.measured_regions.empty()) json["regions"] = regions_json(results, model, state);
    if (state.dynamic_time > 0) {
        json["first_slip"] = slips_json(results.state().first_slips);
        json["blocks_on_planes"] = planes_json(plane_slips(model, stages, state, results));
    }
    if (wears_by_reversals(model))
        json["reversals_close_to_min_slip"] =
            close_reversals_json(model, with_present(results.state().close_reversals, model, state));
    if (state.dynamic_time > 0) json["spring_resolution"] = springs_json(model, stages);
    if (!results.state().left_moving.empty())
        json["moving_at_rest"] = left_moving_json(results.state().left_moving, model, stages);
    json["deepest_contact"] = deepest_contact_json(state.deepest_contact);
    if (!state.lost_blocks.empty()) json["lost_blocks"] = lost_blocks_json(state.lost_blocks, model);
    if (state.broken_bonds.events > 0)
        json["bonds_broken_at_rest"] = {{"contacts", state.broken_bonds.contacts},
                                        {"events", state.broken_bonds.events}};
    if (state.strained_bonds.of > 0)
        json["bonds_at_their_strength"] = {{"contacts", state.strained_bonds.contacts},
                                           {"of", state.strained_bonds.of}};
    json["energy"] = energy_json(state.energy);
    if (!results.state().trials.empty()) json["factor_of_safety"] = factor_of_safety(results.state().trials);
    json["units"] = "SI, per metre of thickness";
    if (const Json motions = motions_json(stages); !motions.empty()) json["motions"] = motions;
    add_provenance(provenance, json);
    return json.dump(2) + "\n";
}

}  // namespace rockslope::dda
