#pragma once

#include <string>
#include <variant>

#include "dda/joint/mohr_coulomb.hpp"

namespace dda {

/// The list of joint laws: a new law is one file in this folder and one word here.
using JointLaw = std::variant<MohrCoulomb>;

namespace detail {
template <class... Laws>
std::variant<typename Laws::History...> histories_of(const std::variant<Laws...>&);
}
/// What a joint remembers: the alternative has the same index as its law in JointLaw.
using JointHistory = decltype(detail::histories_of(std::declval<JointLaw>()));

JointHistory fresh_history(const JointLaw& law);
Strength strength(const JointLaw& law, const JointHistory& history, double normal_force, double length);
JointHistory advance(const JointLaw& law, const JointHistory& history, const ContactMotion& motion);

/// A joint material of the model file: its law and, where given, springs of its own.
struct JointMaterial {
    std::string name;
    JointLaw law;
    double normal_penalty = 0;  ///< N/m per metre per contact; 0: the analysis' value
    double shear_penalty = 0;   ///< likewise
};

}  // namespace dda
