#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

double weight_of_first(const ContactMotion& a, const ContactMotion& b) {
    const auto weight = [](const ContactMotion& m) { return m.stiffness > 0 ? m.stiffness : m.length; };
    const double total_weight = weight(a) + weight(b);
    return total_weight > 0 ? weight(a) / total_weight : 0.5;
}

ContactMotion combine(const ContactMotion& a, const ContactMotion& b, double weight) {
    ContactMotion combined = a;
    combined.slip = weighted_mean(a.slip, b.slip, weight);
    combined.displacement = weighted_mean(a.displacement, b.displacement, weight);
    combined.normal_force += b.normal_force;
    combined.length += b.length;
    combined.shear_force += b.shear_force;
    combined.stiffness += b.stiffness;
    combined.opened = a.opened || b.opened;
    combined.closing = a.closing && b.closing;
    return combined;
}

const char* stage_name(JointStage stage) {
    switch (stage) {
        case JointStage::none:
            return "none";
        case JointStage::forward_advance:
            return "forward advance";
        case JointStage::forward_unloading:
            return "forward unloading";
        case JointStage::forward_return:
            return "forward return";
        case JointStage::backward_advance:
            return "backward advance";
        case JointStage::backward_unloading:
            return "backward unloading";
        case JointStage::backward_return:
            return "backward return";
    }
    return "";
}

}  // namespace rockslope::dda
