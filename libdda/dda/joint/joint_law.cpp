#include "dda/joint/joint_law.hpp"

namespace rockslope::dda {

namespace {

/// Calls `function(law, history)` with the law's own type and the type of its history.
template <class Function>
auto visit_both(const JointLaw& law, const JointHistory& history, Function function) {
    return std::visit(
        [&](const auto& l) {
            using History = typename std::decay_t<decltype(l)>::History;
            return function(l, std::get<History>(history));
        },
        law);
}

}  // namespace

JointHistory fresh_history(const JointLaw& law, bool intact) {
    return std::visit([&](const auto& l) { return JointHistory(l.fresh(intact)); }, law);
}

Strength strength(const JointLaw& law, const JointHistory& history, double normal_force, double length,
                  const ShearTrial& trial) {
    return visit_both(law, history, [&](const auto& l, const auto& h) {
        return l.strength(h, normal_force, length, trial);
    });
}

JointHistory advance(const JointLaw& law, const JointHistory& history, const ContactMotion& motion) {
    return visit_both(law, history, [&]<class Law>(const Law& l, const auto& h) {
        if constexpr (Law::history_scope == HistoryScope::joint_segment)
            if (!(motion.normal_force > 0)) return JointHistory(l.fly(h, motion));
        return JointHistory(l.advance(h, motion));
    });
}

std::optional<Strength> strength_slope(const JointLaw& law, const JointHistory& history, double normal_force,
                                       double length) {
    return visit_both(law, history, [&](const auto& l, const auto& h) -> std::optional<Strength> {
        return l.strength_slope(h, normal_force, length);
    });
}

std::optional<CoulombLine> bound_line(const JointLaw& law, const JointHistory& history) {
    return visit_both(law, history, [](const auto& l, const auto& h) { return l.bound_line(h); });
}

std::optional<CoulombEnvelope> coulomb_envelope(const JointLaw& law) {
    return std::visit([](const auto& l) { return l.coulomb_envelope(); }, law);
}

double dilation(const JointLaw& law, const JointHistory& history) {
    return record(law, history).dilation;
}

LockedDilation locked_dilation(const JointLaw& law, const JointHistory& history) {
    return visit_both(law, history, [](const auto& l, const auto& h) { return l.locked_dilation(h); });
}

double shear_stiffness(const JointLaw& law, const JointHistory& history, double normal_force, double length) {
    return visit_both(law, history, [&](const auto& l, const auto& h) {
        return l.shear_stiffness(h, normal_force, length);
    });
}

JointRecord record(const JointLaw& law, const JointHistory& history) {
    return visit_both(law, history, [](const auto& l, const auto& h) { return l.record(h); });
}

bool has_cohesion(const JointLaw& law) {
    const auto coheres = [&](bool intact) {
        return strength(law, fresh_history(law, intact), 0, 1).forward > 0;
    };
    return coheres(true) || coheres(false);
}

bool has_segment_history(const JointLaw& law) {
    return std::visit([](const auto& l) { return l.history_scope == HistoryScope::joint_segment; }, law);
}

bool dilates(const JointLaw& law) {
    return std::visit([](const auto& l) { return l.dilates() != Dilates::never; }, law);
}

bool dilates_with_slip(const JointLaw& law) {
    return std::visit([](const auto& l) { return l.dilates() == Dilates::with_slip; }, law);
}

}  // namespace rockslope::dda
