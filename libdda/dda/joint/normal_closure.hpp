#pragma once

namespace rockslope::dda {

/// Normal force over closure of a joint: linear, or the hyperbola of Bandis et al. (1983), Eq. (44), F = k c
/// / (1 - c/V), whose stiffness grows with the closure, which is below V. Forces are N per metre with a
/// stiffness in N/m per metre, or Pa with a stiffness in Pa/m; forces and closures are positive in
/// compression. In tension, for bonded joints, the curve is linear.
///
/// Limits: loading and unloading follow one curve, whereas specimens lose energy in a cycle and settle; above
/// 199/200 of the largest closure, beyond the strength of any rock, the curve is straight.
struct NormalClosure {
    double stiffness = 0;        ///< k, at zero force; positive
    double largest_closure = 0;  ///< V, m; 0: linear

    /// Normal force at a closure, Eq. (44), N per metre; proportional to a negative closure. @param closed m.
    double force(double closure) const;
    /// m
    double closure(double force) const;
    /// Tangent stiffness at a force.
    double tangent(double force) const;
    /// Energy stored at a force: J per metre, or J per square metre.
    double energy(double force) const;
    /// Whether the closure has no limit.
    bool is_linear() const { return largest_closure == 0; }
    friend bool operator==(const NormalClosure&, const NormalClosure&) = default;
};

}  // namespace rockslope::dda
