#pragma once

namespace rockslope::dda {

/// How a joint closes under a normal force. Linear, or the hyperbola of Bandis et al. (1983), Eq. (44):
/// F = k c / (1 - c/V), stiffer the more the joint is closed, and at most by V. Forces are N per metre with a
/// stiffness in N/m per metre, or Pa with one in Pa/m; forces and closures are positive in compression. In
/// tension, for bonded joints, it is linear.
///
/// Limits: loading and unloading follow one curve, where specimens lose energy in a cycle and settle; from
/// 199/200 of the largest closure on, beyond any stress that rock bears, the curve goes on straight.
struct NormalClosure {
    double stiffness = 0;        ///< k, at no force; positive
    double largest_closure = 0;  ///< V, m; 0: linear

    double force(double closure) const;
    /// m
    double closure(double force) const;
    /// The stiffness at a force.
    double tangent(double force) const;
    /// What closing the joint to a force stores: J per metre, or per square metre.
    double energy(double force) const;
    bool is_linear() const { return largest_closure == 0; }
    friend bool operator==(const NormalClosure&, const NormalClosure&) = default;
};

}  // namespace rockslope::dda
