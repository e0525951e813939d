#include "dda/joint/joint_law.hpp"

namespace dda {

JointHistory fresh_history(const JointLaw& law, bool intact) {
    return std::visit([&](const auto& l) { return JointHistory(l.fresh(intact)); }, law);
}

Strength strength(const JointLaw& law, const JointHistory& history, double normal_force, double length) {
    return std::visit(
        [&](const auto& l) {
            using History = typename std::decay_t<decltype(l)>::History;
            return l.strength(std::get<History>(history), normal_force, length);
        },
        law);
}

JointHistory advance(const JointLaw& law, const JointHistory& history, const ContactMotion& motion) {
    return std::visit(
        [&](const auto& l) {
            using History = typename std::decay_t<decltype(l)>::History;
            return JointHistory(l.advance(std::get<History>(history), motion));
        },
        law);
}

}  // namespace dda
