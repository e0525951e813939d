#include "blockgen/sample_joints.hpp"

#include <algorithm>

#include "blockgen/sampling/rock_measure.hpp"
#include "blockgen/sampling/set_sampler.hpp"

namespace blockgen {

std::vector<Trace> sample_joint_set(const JointSet& set, const SlopeModel& model,
                                    const std::vector<Trace>& others, std::size_t most_draws) {
    SetSampler sampler(set, model, most_draws);
    std::vector<Trace> traces;
    if (set.kind == SetKind::parallel) traces = sample_parallel(sampler);
    if (set.kind == SetKind::cross_jointed) traces = sample_cross_joints(sampler, others);
    const bool measures_rock =
        set.kind == SetKind::baecher || set.kind == SetKind::veneziano || set.kind == SetKind::voronoi;
    if (!measures_rock && set.region.empty()) return traces;

    const RockMeasure rock(model, set.region);
    if (measures_rock && !(rock.area() > 0))
        throw InputError(set.place, "joint set '" + set.name + "' has no rock to lie in",
                         "a region within the domain");
    if (set.kind == SetKind::baecher) traces = sample_baecher(sampler, rock);
    if (set.kind == SetKind::veneziano) traces = sample_veneziano(sampler, rock);
    if (set.kind == SetKind::voronoi) traces = sample_voronoi(sampler, rock);
    if (set.region.empty()) return traces;
    std::vector<Trace> clipped;
    for (const Trace& trace : traces)
        for (const auto& [a, b] : rock.pieces_in_region(trace.points[0], trace.points[1]))
            clipped.push_back({trace.name, trace.joint_material, {a, b}});
    return clipped;
}

std::vector<Trace> all_traces(const SlopeModel& model) {
    std::vector<Trace> traces = model.traces;
    for (const JointSet& set : model.joint_sets) {
        std::vector<Trace> others;
        if (set.kind == SetKind::cross_jointed)
            std::copy_if(traces.begin(), traces.end(), std::back_inserter(others),
                         [&](const Trace& trace) { return trace.name == set.ends_on; });
        for (Trace& trace : sample_joint_set(set, model, others)) traces.push_back(std::move(trace));
    }
    return traces;
}

}  // namespace blockgen
