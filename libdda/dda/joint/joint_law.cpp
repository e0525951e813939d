#include "dda/joint/joint_law.hpp"

namespace rockslope::dda {

namespace {

/// Calls `with(law, its own history)`.
template <class With>
auto visit_both(const JointLaw& law, const JointHistory& history, With with) {
    return std::visit(
        [&](const auto& l) {
            using History = typename std::decay_t<decltype(l)>::History;
            return with(l, std::get<History>(history));
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
        if constexpr (requires { l.strength(h, normal_force, length, trial); })
            return l.strength(h, normal_force, length, trial);
        else
            return l.strength(h, normal_force, length);
    });
}

JointHistory advance(const JointLaw& law, const JointHistory& history, const ContactMotion& motion) {
    return visit_both(law, history,
                      [&](const auto& l, const auto& h) { return JointHistory(l.advance(h, motion)); });
}

std::optional<Strength> strength_slope(const JointLaw& law, const JointHistory& history, double normal_force,
                                       double length) {
    return visit_both(law, history, [&](const auto& l, const auto& h) -> std::optional<Strength> {
        if constexpr (requires { l.strength_slope(h, normal_force, length); })
            return l.strength_slope(h, normal_force, length);
        else
            return std::nullopt;
    });
}

double dilation(const JointLaw& law, const JointHistory& history) {
    return record(law, history).dilation;
}

double shear_stiffness(const JointLaw& law, const JointHistory& history, double normal_force, double length) {
    return visit_both(law, history, [&](const auto& l, const auto& h) {
        if constexpr (requires { l.shear_stiffness(h, normal_force, length); })
            return l.shear_stiffness(h, normal_force, length);
        else
            return 0.0;
    });
}

JointRecord record(const JointLaw& law, const JointHistory& history) {
    return visit_both(law, history, [](const auto& l, const auto& h) {
        if constexpr (requires { l.record(h); })
            return l.record(h);
        else
            return JointRecord{};
    });
}

bool has_segment_history(const JointLaw& law) {
    return std::visit(
        [](const auto& l) {
            using History = typename std::decay_t<decltype(l)>::History;
            return requires(const History& h) {
                l.record(h);
            };
        },
        law);
}

bool dilates(const JointLaw& law) {
    return has_segment_history(law) && std::visit(
                                           [](const auto& l) {
                                               if constexpr (requires { l.damage; })
                                                   return l.damage > 0;
                                               else
                                                   return true;
                                           },
                                           law);
}

}  // namespace rockslope::dda
