#include "blockgen/sampling/sample_joints.hpp"

#include <optional>

#include "blockgen/sampling/expected_draws.hpp"
#include "blockgen/sampling/rock_domain.hpp"
#include "blockgen/sampling/set_sampler.hpp"

namespace rockslope::blockgen {

namespace {

std::vector<Trace> sample(SetSampler& sampler, const std::optional<RockDomain>& rock,
                          const std::vector<Trace>& others) {
    switch (sampler.set().kind) {
        case SetKind::parallel:
            return sample_parallel(sampler);
        case SetKind::baecher:
            return sample_baecher(sampler, *rock);
        case SetKind::veneziano:
            return sample_veneziano(sampler, *rock);
        case SetKind::cross_jointed:
            return sample_cross_joints(sampler, others);
        case SetKind::voronoi:
            return sample_voronoi(sampler, *rock);
    }
    return {};
}

}  // namespace

std::vector<Trace> sample_joint_set(const JointSet& set, const SlopeModel& model,
                                    const std::vector<Trace>& others, std::size_t max_draws) {
    SetSampler sampler(set, model, max_draws);
    const bool measures_rock =
        set.kind == SetKind::baecher || set.kind == SetKind::veneziano || set.kind == SetKind::voronoi;
    std::optional<RockDomain> rock;
    if (measures_rock || !set.region.empty()) rock.emplace(model, set.region);
    if (measures_rock && !(rock->area() > 0))
        throw InputError(set.place, "there is no rock in the region of joint set '" + set.name + "'",
                         "a region within the domain");
    check_expected_draws(sampler, rock ? &*rock : nullptr, others);
    std::vector<Trace> traces = sample(sampler, rock, others);
    if (set.region.empty()) return traces;
    std::vector<Trace> clipped;
    for (const Trace& trace : traces)
        for (const auto& [a, b] : rock->pieces_in_region(trace.points[0], trace.points[1]))
            clipped.push_back({trace.name, trace.joint_material, {a, b}});
    return clipped;
}

std::vector<Trace> all_traces(const SlopeModel& model, std::size_t max_blocks) {
    std::vector<Trace> traces = model.traces;
    const std::size_t max_traces = max_draws_for(max_blocks) + traces.size();
    for (const JointSet& set : model.joint_sets) {
        std::vector<Trace> others;
        if (set.kind == SetKind::cross_jointed)
            std::copy_if(traces.begin(), traces.end(), std::back_inserter(others),
                         [&](const Trace& trace) { return trace.name == set.ends_on; });
        const std::size_t max_draws = max_traces - std::min(max_traces, traces.size());
        for (Trace& trace : sample_joint_set(set, model, others, max_draws))
            traces.push_back(std::move(trace));
    }
    return traces;
}

}  // namespace rockslope::blockgen
