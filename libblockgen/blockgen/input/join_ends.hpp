#pragma once

#include "blockgen/input/slope_model.hpp"

namespace rockslope::blockgen {

/// Joins each end of a given trace that lies within `snap` of another end, of another trace or of an outline
/// to it, and counts the ends that stop short of something all the same. An end moves by `snap` at most;
/// where it comes to lie on a trace, that trace gets a vertex there. Ends that lie on something already stay,
/// and so do ends of a trace that crosses what they are near to. The result does not depend on the order of
/// the traces. Fills model.trace_ends and adds a note when more ends than chance explains stop just short.
/// @param snap m; 0 joins nothing and only counts.
void join_ends(double snap, SlopeModel& model);

}  // namespace rockslope::blockgen
