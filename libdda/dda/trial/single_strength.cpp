#include "dda/trial/single_strength.hpp"

#include <algorithm>

#include "dda/trial/joint_motion.hpp"

namespace rockslope::dda {

Strength single_strength(const StepProblem& problem, ContactIndex contact, const ContactLoading& loading) {
    const Contact& at_start = problem.contacts[contact];
    const JointLaw& law = problem.model.joint_material_at(at_start.joint_material).law;
    const ContactMotion motion =
        contact_motion(problem.model, at_start, problem.springs[contact].shear_stiffness, loading.normal,
                       loading.shearing, 0);
    const Strength whole = strength(law, at_start.history, motion.normal_force, motion.length,
                                    {motion.displacement, motion.shear_force, motion.stiffness});
    const double reduced = 1 / problem.model.strength_reduction;
    const Strength strengths{whole.forward * reduced, whole.backward * reduced, whole.tensile * reduced};
    if (!problem.bonds_hold() || problem.held_shares[contact] == 1) return strengths;
    const double held = problem.held_shares[contact];
    const Strength bond = strength(law, at_start.history, 0, motion.length);
    const double not_held = (1 - held) * reduced;
    return {std::max(strengths.forward - not_held * bond.forward, 0.0),
            std::max(strengths.backward - not_held * bond.backward, 0.0), held * strengths.tensile};
}

}  // namespace rockslope::dda
