#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// A law of joint segments gives the flight of an open joint, see `fly` of JointLawContract. A law of single
/// contacts has neither a position nor a dilation.
template <class Law>
concept FollowsItsWalls = Law::history_scope == HistoryScope::contact ||
                          requires(const Law law, const typename Law::History history,
                                   const ContactMotion& motion) {
    { law.fly(history, motion) } -> std::same_as<typename Law::History>;
};

// clang-format off
/// The contract of a joint law. Every member below is required; a law without an answer says so (`nullopt`,
/// 0, an empty record). Forces are N per metre of thickness, compression positive; lengths are in m.
///
/// Constants:
/// - `name`: the value of `law = "..."` in a model file;
/// - `history_scope`: whether each contact or each joint segment has a history. Only laws of joint segments
///   may dilate;
/// - `History`: trivially copyable, because checkpoints contain its bytes;
/// - `common_histories()`: a constant array of the histories that most contacts have, if they are few, else
///   an empty one (`NoCommonHistories`). Each of them is stored once.
///
/// Functions of the law alone:
/// - `read(table)`: the law of a table of the model file. @throws InputError;
/// - `dilates()`: whether and how shearing may open the joint. If never, `record(history).dilation` is always
///   0;
/// - `coulomb_envelope()`: the peak and the residual line of a law with Coulomb strength, else nullopt.
///
/// Functions of the history:
/// - `fresh(intact)`: the history of a joint before any motion. `intact` is false for faces that met later;
/// - `strength(history, normal_force, length, trial)`: the strength at the end of the trial displacement. It
///   is evaluated many times in a step;
/// - `strength_slope(history, normal_force, length)`: the derivative of the strength at rest with respect to
///   the normal force, dimensionless, or nullopt;
/// - `bound_line(history)`: the shear strength as a straight line over the normal force, if it is one
///   whatever the trial, else nullopt: then the friction coupling linearises the strength numerically;
/// - `advance(history, motion)`: the history after an accepted step. The normal force of a joint segment is
///   positive; an open one flies;
/// - `fly(history, motion)`, for laws of joint segments: the history after a motion of the walls of an open
///   joint. The position of the joint follows its walls, and its dilation is what sliding under a vanishing
///   normal force would give, so that the joint lands where it is. The slip is the displacement and what the
///   shear spring has been released by. No work is done, so nothing wears: the strength of each place stays
///   the same. A dilation that was not negative does not become so;
/// - `shear_stiffness(history, normal_force, length)`: N/m per metre, of the shear spring that the law gives
///   a contact, or 0;
/// - `locked_dilation(history)`: how the shear force of the locked joint follows its normal force, Eq. (77);
///   `{}` if only slip dilates it;
/// - `record(history)`: the part of the history that the results contain.
template <class Law>
concept JointLawContract = FollowsItsWalls<Law> &&
    requires(const Law law, const typename Law::History history, double normal_force, double length,
             bool intact, const ShearTrial& trial, const ContactMotion& motion, const ParameterTable& table) {
        { Law::name } -> std::convertible_to<const char*>;
        { Law::history_scope } -> std::same_as<const HistoryScope&>;
        typename std::integral_constant<std::size_t, Law::common_histories().size()>;
        { Law::common_histories()[std::size_t{0}] } -> std::convertible_to<typename Law::History>;
        { Law::read(table) } -> std::same_as<Law>;
        { law.dilates() } -> std::same_as<Dilates>;
        { law.coulomb_envelope() } -> std::same_as<std::optional<CoulombEnvelope>>;
        { law.fresh(intact) } -> std::same_as<typename Law::History>;
        { law.strength(history, normal_force, length, trial) } -> std::same_as<Strength>;
        { law.strength_slope(history, normal_force, length) } -> std::convertible_to<std::optional<Strength>>;
        { law.bound_line(history) } -> std::same_as<std::optional<CoulombLine>>;
        { law.advance(history, motion) } -> std::same_as<typename Law::History>;
        { law.shear_stiffness(history, normal_force, length) } -> std::same_as<double>;
        { law.locked_dilation(history) } -> std::same_as<LockedDilation>;
        { law.record(history) } -> std::same_as<JointRecord>;
    } && std::is_trivially_copyable_v<typename Law::History> &&
    std::equality_comparable<typename Law::History>;
// clang-format on

/// Each law of a list against the contract; the compiler's message names the law and the missing member.
template <class Law>
struct CheckedJointLaw {
    static_assert(
        JointLawContract<Law>,
        "this law does not fulfil JointLawContract: the notes below name the member that is missing "
        "or has another type");
    using History = typename Law::History;
};

}  // namespace rockslope::dda
