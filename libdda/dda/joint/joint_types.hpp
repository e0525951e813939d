#pragma once

namespace dda {

/// What a joint can bear at a contact, N per metre of thickness, all non-negative.
struct Strength {
    double forward = 0;   ///< largest shear force against slip in the positive tangential direction
    double backward = 0;  ///< largest shear force against slip in the negative tangential direction
    double tensile = 0;   ///< largest tensile normal force before the contact opens
};

/// What happened at a contact during an accepted step.
struct ContactMotion {
    double slip = 0;          ///< plastic tangential slip of the step, m, positive forward
    double displacement = 0;  ///< total tangential displacement of the step, m
    double normal_force = 0;  ///< at the end of the step, N per metre, compression positive
    double length = 0;        ///< the contact's share of the joint, m
    bool opened = false;      ///< the contact was bonded and tore
};

}  // namespace dda
