#include "blockgen/arrangement/exact_network.hpp"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>

namespace rockslope::blockgen {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
/// Pieces of segments know the numbers of all segments that run along them.
using Traits = CGAL::Arr_consolidated_curve_data_traits_2<CGAL::Arr_segment_traits_2<Kernel>, std::int32_t>;
using Dcel = CGAL::Arr_extended_dcel<Traits, std::int32_t, char, char>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;

/// A coordinate in cells from the frame's origin, exactly: a double where the difference is one.
Kernel::FT cells_of(double x, double origin, double step) {
    const double difference = x - origin, back = difference + origin;
    const double error = (x - back) + (origin - (back - difference));
    const double cells = difference / step;  // a power of two
    return error == 0 ? Kernel::FT(cells) : (Kernel::FT(x) - Kernel::FT(origin)) / Kernel::FT(step);
}

std::vector<std::int32_t> segments_through(Arrangement::Vertex_const_handle v) {
    std::vector<std::int32_t> segments;
    auto h = v->incident_halfedges();
    do segments.insert(segments.end(), h->curve().data().begin(), h->curve().data().end());
    while (++h != v->incident_halfedges());
    std::sort(segments.begin(), segments.end());
    segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
    return segments;
}

std::vector<std::int32_t> cycle_of(Arrangement::Ccb_halfedge_const_circulator start) {
    std::vector<std::int32_t> cycle;
    auto h = start;
    do cycle.push_back(h->source()->data());
    while (++h != start);
    return cycle;
}

}  // namespace

ExactNetwork arrange_segments(std::span<const SourceSegment> segments, const GridFrame& frame) {
    const auto point_of = [&](const Point& p) {
        return Kernel::Point_2(cells_of(p.x, frame.origin.x, frame.step),
                               cells_of(p.y, frame.origin.y, frame.step));
    };
    std::vector<Traits::Curve_2> curves;
    for (std::size_t k = 0; k < segments.size(); ++k)
        if (segments[k].a != segments[k].b)
            curves.emplace_back(Kernel::Segment_2(point_of(segments[k].a), point_of(segments[k].b)),
                                static_cast<std::int32_t>(k));
    Arrangement arrangement;
    CGAL::insert(arrangement, curves.begin(), curves.end());

    ExactNetwork network;
    for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) {
        v->set_data(static_cast<std::int32_t>(network.vertices.size()));
        network.vertices.push_back({CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y())});
        network.segments_at.push_back(segments_through(v));
    }
    network.faces.emplace_back();
    for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f) {
        auto& cycles = f->is_unbounded() ? network.faces.front() : network.faces.emplace_back();
        if (!f->is_unbounded()) cycles.push_back(cycle_of(f->outer_ccb()));
        for (auto hole = f->inner_ccbs_begin(); hole != f->inner_ccbs_end(); ++hole)
            cycles.push_back(cycle_of(*hole));
    }
    return network;
}

}  // namespace rockslope::blockgen
