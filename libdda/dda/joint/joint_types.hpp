#pragma once

#include <cstdint>

namespace rockslope::dda {

/// What a joint can bear at a contact, N per metre of thickness, all non-negative.
struct Strength {
    double forward = 0;   ///< largest shear force against slip in the positive tangential direction
    double backward = 0;  ///< largest shear force against slip in the negative tangential direction
    double tensile = 0;   ///< largest tensile normal force before the contact opens
};

/// A tangential displacement that is being tried. A law whose strength depends on where the joint is looks it
/// up at the end of the displacement; the other laws have no use for it.
struct ShearTrial {
    double displacement = 0;  ///< total tangential displacement of the step, m, positive forward
    double shear_force = 0;   ///< at the start of the step, N per metre
    double stiffness = 0;     ///< of the shear spring, N/m per metre; 0: not told
};

/// What happened at a contact during an accepted step.
struct ContactMotion {
    double slip = 0;          ///< plastic tangential slip of the step, m, positive forward
    double displacement = 0;  ///< total tangential displacement of the step, m
    double normal_force = 0;  ///< at the end of the step, N per metre, compression positive
    double length = 0;        ///< the contact's share of the joint, m
    bool opened = false;      ///< the contact was bonded and tore
    double shear_force = 0;   ///< at the start of the step, N per metre
    double stiffness = 0;     ///< of the shear spring, N/m per metre; 0: not told
    double duration = 0;      ///< of the step, s; 0: not told, or a static step
};

/// Two ends of a joint as one: forces, lengths and stiffnesses add up, displacements are those of the whole.
ContactMotion combine(const ContactMotion& a, const ContactMotion& b);

/// Side of the origin on which a joint is, and how it moves there: away from the origin it advances; towards
/// it, it unloads while locked and returns while it slides.
enum class JointStage : std::uint8_t {
    none,  ///< the law knows no stages, or the joint has not moved
    forward_advance,
    forward_unloading,
    forward_return,
    backward_advance,
    backward_unloading,
    backward_return
};

/// A stage of shearing as it stands in tables: "forward advance" and so on.
const char* stage_name(JointStage stage);

/// What a joint's history tells the reader of the results. A law without one of these leaves it as it is.
struct JointRecord {
    JointStage stage = JointStage::none;
    double mobilised_ratio = 0;  ///< roughness at work over peak roughness, negative where it helps the slip
    double dilation = 0;         ///< m, by which shearing has moved the faces apart; negative: together
    int reversals = 0;           ///< changes of slip direction so far
    int cycle = 0;               ///< of shearing, from 1
};

}  // namespace rockslope::dda
