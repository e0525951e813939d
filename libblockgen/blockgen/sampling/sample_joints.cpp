#include "blockgen/sampling/sample_joints.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

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
            return sample_baecher(sampler, *rock, others);
        case SetKind::veneziano:
            return sample_veneziano(sampler, *rock, others);
        case SetKind::cross_jointed:
            return sample_cross_joints(sampler, others);
        case SetKind::voronoi:
            return sample_voronoi(sampler, *rock);
    }
    return {};
}

/// The rock that was not mapped, as a model: that without a tunnel of the mapped area.
SlopeModel without_mapped_area(const SlopeModel& model, const JointSet& set) {
    SlopeModel rest;
    rest.grid = model.grid;
    rest.outline = model.outline;
    rest.further_outlines = model.further_outlines;
    rest.holes = model.holes;
    rest.holes_location = model.holes_location;
    rest.tunnels = model.tunnels;
    rest.tunnels.push_back({"mapped area", set.mapped_area, set.place});
    return rest;
}

/// The pieces of traces outside the mapped area that are longer than a grid step.
std::vector<Trace> outside_mapped_area(const std::vector<Trace>& traces, const Ring& area, double grid) {
    std::vector<Trace> outside;
    for (const Trace& trace : traces) {
        const auto add = [&](const Point& a, const Point& b) {
            if (std::hypot(b.x - a.x, b.y - a.y) > grid)
                outside.push_back({trace.name, trace.joint_material, {a, b}, trace.draw});
        };
        Point from = trace.points[0];
        for (const auto& [a, b] : clip_to_ring(from, trace.points[1], area)) {
            add(from, a);
            from = b;
        }
        add(from, trace.points[1]);
    }
    return outside;
}

/// Samples a set that fills up what was mapped: the rest of the rock where the mapped area is given.
std::vector<Trace> sample_beside_mapped_area(SetSampler& sampler, const SlopeModel& model) {
    const JointSet& set = sampler.set();
    const SlopeModel rest = without_mapped_area(model, set);
    std::optional<RockDomain> rock(std::in_place, rest, std::string());
    if (!(rock->area() > 0)) return {};
    check_expected_draws(sampler, &*rock, {});
    return outside_mapped_area(sample(sampler, rock, {}), set.mapped_area, model.grid);
}

}  // namespace

std::vector<Trace> sample_joint_set(const JointSet& set, const SlopeModel& model,
                                    const std::vector<Trace>& others, const DrawLimit& limit) {
    SetSampler sampler(set, model, limit);
    if (!set.mapped_area.empty()) return sample_beside_mapped_area(sampler, model);
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
            clipped.push_back({trace.name, trace.joint_material, {a, b}, trace.draw});
    return clipped;
}

std::vector<Trace> all_traces(const SlopeModel& model, std::size_t max_blocks) {
    std::vector<Trace> traces = model.traces;
    for (const JointSet& set : model.joint_sets) {
        std::vector<Trace> others;
        const std::string& name = set.kind == SetKind::cross_jointed ? set.ends_on : set.conditioned_on;
        if (!name.empty())
            std::copy_if(traces.begin(), traces.end(), std::back_inserter(others),
                         [&](const Trace& trace) { return trace.name == name; });
        const DrawLimit limit{max_blocks, traces.size() - model.traces.size()};
        for (Trace& trace : sample_joint_set(set, model, others, limit)) traces.push_back(std::move(trace));
    }
    return traces;
}

}  // namespace rockslope::blockgen
