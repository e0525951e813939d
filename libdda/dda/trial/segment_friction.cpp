#include "dda/trial/segment_friction.hpp"

namespace rockslope::dda {

namespace {

/// Exponent b in strength / normal force ~ (normal force)^b. @param half, @param whole the ratio under half
/// of the normal force and under all of it.
double strength_exponent(double half, double whole) {
    return half > 0 && whole > 0 ? std::log2(whole / half) : 0;
}

}  // namespace

SegmentFriction::SegmentFriction(const StepProblem& problem, const ThreadPool& pool)
    : pool_(pool), strength_(problem), segments_(strength_.count()) {}

void SegmentFriction::evaluate_law(std::size_t segment, const SegmentLoading& loading) {
    const bool any = loading.normal > 0;
    segments_[segment].evaluated_at = any ? loading : Segment().evaluated_at;
    segments_[segment].over_normal_force = any ? strength_.over_normal_force(segment, loading) : Strength{};
    segments_[segment].hardening =
        any ? strength_.hardening(segment, loading, segments_[segment].over_normal_force) : Hardening{};
}

void SegmentFriction::request_line(ContactIndex contact) {
    const std::size_t index = strength_.segment_of(contact);
    Segment& segment = segments_[index];
    if (segment.has_exponents || segment.requested) return;
    segment.requested = true;
    requested_.push_back(index);
}

void SegmentFriction::find_exponents(std::size_t index) {
    Segment& segment = segments_[index];
    segment.requested = false;
    if (std::isnan(segment.evaluated_at.normal)) return;
    const Strength half = strength_.over_normal_force(
        index, {segment.evaluated_at.normal / 2, segment.evaluated_at.displacement});
    segment.forward_exponent = strength_exponent(half.forward, segment.over_normal_force.forward);
    segment.backward_exponent = strength_exponent(half.backward, segment.over_normal_force.backward);
    segment.has_exponents = true;
}

ShearLine SegmentFriction::line(ContactIndex contact, bool forward, double normal_force) const {
    const Segment& segment = segment_of(contact);
    const double ratio = forward ? segment.over_normal_force.forward : segment.over_normal_force.backward;
    const double curvature_term = ratio * (forward ? segment.forward_exponent : segment.backward_exponent);
    return {.slope = ratio + curvature_term,
            .cohesion = -curvature_term * std::max(normal_force, 0.0),
            .is_missing = !segment.has_exponents};
}

}  // namespace rockslope::dda
