#pragma once

#include <cstddef>
#include <vector>

#include "blockgen/input/slope_model.hpp"

namespace rockslope::blockgen {

/// The part of the plane that was mapped.
struct MapWindow {
    std::vector<Ring> outer;  ///< counter-clockwise or not; they do not overlap
    std::vector<Ring> holes;

    /// m2.
    double area() const;
    /// Whether a point was mapped; the edge was.
    bool contains(const Point& p) const;
};

/// A connected piece of a trace within the window.
struct MappedPiece {
    Point a, b;             ///< its ends
    double length = 0;      ///< along the trace, m
    int ends = 0;           ///< how many of its ends are seen: the others lie at the window's edge
    std::size_t trace = 0;  ///< number of its trace
};

/// The pieces of traces within a window. @param edge m: an end that near to the window's edge, or nearer, is
/// where the mapping ended and not the joint.
std::vector<MappedPiece> mapped_pieces(const std::vector<Trace>& traces, const MapWindow& window,
                                       double edge);

/// The parameters t in ascending order between which the points a + t (b - a) lie within the window: t enters
/// at even and leaves at odd positions. @param low, high limits of t.
std::vector<double> stretches_within(const MapWindow& window, const Point& a, const Point& b, double low,
                                     double high);

}  // namespace rockslope::blockgen
