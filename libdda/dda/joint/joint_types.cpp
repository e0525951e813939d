#include "dda/joint/joint_types.hpp"

namespace dda {

ContactMotion together(const ContactMotion& a, const ContactMotion& b) {
    const auto weight = [](const ContactMotion& m) { return m.stiffness > 0 ? m.stiffness : m.length; };
    const double both = weight(a) + weight(b);
    const double share = both > 0 ? weight(a) / both : 0.5;
    ContactMotion whole = a;
    whole.slip = share * a.slip + (1 - share) * b.slip;
    whole.displacement = share * a.displacement + (1 - share) * b.displacement;
    whole.normal_force += b.normal_force;
    whole.length += b.length;
    whole.shear_force += b.shear_force;
    whole.stiffness += b.stiffness;
    whole.opened = a.opened || b.opened;
    return whole;
}

}  // namespace dda
