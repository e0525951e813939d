#include "blockgen/report/joint_planes.hpp"

#include <algorithm>
#include <numbers>
#include <unordered_map>

#include "blockgen/report/fisher_estimate.hpp"
#include "blockgen/sampling/set_sampler.hpp"
#include "common/geometry/axis_density.hpp"

namespace rockslope::blockgen {

namespace {

/// Flags the traces with a piece in the rock.
PerJointTrace<char> traces_in_rock(const CutContext& cut) {
    PerJointTrace<char> in_rock(cut.traces.size(), 0);
    for (const EdgeIndex e : cut.noded.edges.indices()) {
        if (cut.block_of(forward_half(e)) == FaceBlocks::outside ||
            cut.block_of(backward_half(e)) == FaceBlocks::outside)
            continue;
        for (const EdgeSource& s : cut.noded.sources_of(e))
            if (cut.table.is_joint(s.source)) in_rock[cut.table.trace_of(s.source)] = 1;
    }
    return in_rock;
}

/// The draws of planes with a trace in the rock, by set, ascending.
std::vector<std::vector<std::int64_t>> draws_in_rock(const CutContext& cut) {
    const std::vector<JointSet>& sets = cut.model.joint_sets;
    std::unordered_map<std::string, std::size_t> set_of_name;
    for (std::size_t k = 0; k < sets.size(); ++k)
        if (!sets[k].orientation.poles.empty()) set_of_name.emplace(sets[k].name, k);
    std::vector<std::vector<std::int64_t>> draws(sets.size());
    if (set_of_name.empty()) return draws;
    const PerJointTrace<char> in_rock = traces_in_rock(cut);
    for (const JointTraceIndex t : in_rock.indices()) {
        if (!in_rock[t] || !cut.traces[t].draw) continue;
        if (const auto found = set_of_name.find(cut.traces[t].name); found != set_of_name.end())
            draws[found->second].push_back(*cut.traces[t].draw);
    }
    for (std::vector<std::int64_t>& of_set : draws) {
        std::sort(of_set.begin(), of_set.end());
        of_set.erase(std::unique(of_set.begin(), of_set.end()), of_set.end());
    }
    return draws;
}

JointPlanes planes_of_set(const JointSet& set, const SlopeModel& model,
                          const std::vector<std::int64_t>& draws) {
    const SetSampler sampler(set, model, {});
    const double azimuth = model.section ? model.section->azimuth : 0;
    std::vector<Pole> poles;
    JointPlanes result;
    for (const std::int64_t draw : draws) {
        poles.push_back(sampler.plane(draw));
        result.planes.push_back(plane_of(poles.back(), azimuth));
    }
    const FisherEstimate estimate = fisher_estimate(poles);
    result.name = set.name;
    result.mean = plane_of(estimate.mean, azimuth);
    result.asked_k = set.orientation.fisher_k;
    result.k = estimate.k;
    result.weighted_by_section = set.orientation.weighted_by_section;
    return result;
}

}  // namespace

std::vector<JointPlanes> joint_planes(const CutContext& cut) {
    std::vector<JointPlanes> planes;
    const std::vector<std::vector<std::int64_t>> draws = draws_in_rock(cut);
    for (std::size_t k = 0; k < draws.size(); ++k)
        if (!draws[k].empty()) planes.push_back(planes_of_set(cut.model.joint_sets[k], cut.model, draws[k]));
    return planes;
}

DensestPlanes densest_planes(const std::vector<JointPlanes>& sets) {
    std::vector<SpaceDirection> poles;
    for (const JointPlanes& set : sets)
        for (const PlaneAngles& plane : set.planes)
            poles.push_back(downward_pole(plane.dip, plane.dip_direction));
    const AxisDensity density(poles);
    const AxisDensity::Peak peak = density.peak();
    // In the axes of a section towards the east.
    const Pole pole{peak.axis.east, -peak.axis.down, peak.axis.north};
    return {poles.size(), peak.density, density.uniform_deviation(), plane_of(pole, std::numbers::pi / 2)};
}

}  // namespace rockslope::blockgen
