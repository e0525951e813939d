#pragma once

#include <span>
#include <vector>

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace dda {

/// How deep, m, each vertex-vertex line's pair of corners is in a face along that line already: 0 where it is
/// in none, and for contacts of no group. A corner that slides from one block's face onto its neighbour's is
/// as deep in the second, when it gets there, as it was in the first; that depth is no reason to meet the
/// neighbour's side (theory, Eq. (28)).
/// @param vertices, contacts at the same instant; the forces are those of the contacts' states.
std::vector<double> known_depths(const Model& model, std::span<const Vec2> vertices,
                                 std::span<const Contact> contacts);

}  // namespace dda
