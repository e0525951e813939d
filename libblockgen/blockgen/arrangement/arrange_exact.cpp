#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "blockgen/arrangement/arrange.hpp"

namespace rockslope::blockgen {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Dcel = CGAL::Arr_face_extended_dcel<Traits, std::int32_t>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;

/// An exact number as an integer; -1, which no bounded face has as its area, when it is a fraction.
Int128 integer_of(const Kernel::FT& value) {
    std::ostringstream text;
    text << CGAL::exact(value);
    const std::string digits = text.str();
    Int128 result = 0;
    for (const char digit : digits) {
        if (digit == '/') return -1;
        if (digit != '-') result = 10 * result + (digit - '0');
    }
    return digits[0] == '-' ? -result : result;
}

template <class Circulator>
Kernel::FT twice_ring_area(Circulator start) {
    Kernel::FT sum = 0;
    auto h = start;
    do {
        const auto& p = h->source()->point();
        const auto& q = h->target()->point();
        sum += p.x() * q.y() - p.y() * q.x();
    } while (++h != start);
    return sum;
}

/// Sorts the areas and fills the adjacency by ranks of area.
void fill_areas_and_adjacency(ArrangementSummary& summary, const PerFace<Int128>& area_of_face,
                              const std::vector<std::pair<FaceIndex, FaceIndex>>& neighbours) {
    summary.twice_areas.assign(area_of_face.begin() + 1, area_of_face.end());
    std::sort(summary.twice_areas.begin(), summary.twice_areas.end());
    const auto rank = [&](FaceIndex face) -> std::int32_t {
        if (face == 0) return -1;
        const auto found =
            std::lower_bound(summary.twice_areas.begin(), summary.twice_areas.end(), area_of_face[face]);
        return found - summary.twice_areas.begin();
    };
    for (const auto& [f, g] : neighbours) summary.adjacency.push_back(std::minmax({rank(f), rank(g)}));
    std::sort(summary.adjacency.begin(), summary.adjacency.end());
}

}  // namespace

ArrangementSummary arrange_exactly(const NodedEdges& noded) {
    const auto point_of = [&](NodeIndex v) {
        const GridPoint& p = noded.vertices[v];
        return Kernel::Point_2(static_cast<double>(p.x), static_cast<double>(p.y));
    };
    std::vector<Traits::Curve_2> curves;
    for (const auto& [a, b] : noded.edges) curves.emplace_back(point_of(a), point_of(b));
    Arrangement arrangement;
    CGAL::insert(arrangement, curves.begin(), curves.end());

    ArrangementSummary summary;
    summary.vertices = arrangement.number_of_vertices();
    summary.edges = arrangement.number_of_edges();
    PerFace<Int128> areas(1, 0);
    for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f) {
        f->set_data(f->is_unbounded() ? 0 : static_cast<std::int32_t>(areas.size()));
        if (f->is_unbounded()) continue;
        Kernel::FT area = twice_ring_area(f->outer_ccb());
        for (auto hole = f->inner_ccbs_begin(); hole != f->inner_ccbs_end(); ++hole)
            area += twice_ring_area(*hole);
        areas.push_back(integer_of(area));
    }
    std::vector<std::pair<FaceIndex, FaceIndex>> neighbours;
    for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e)
        neighbours.emplace_back(e->face()->data(), e->twin()->face()->data());
    fill_areas_and_adjacency(summary, areas, neighbours);
    return summary;
}

ArrangementSummary summarize(const NodedEdges& noded, const Subdivision& subdivision) {
    ArrangementSummary summary;
    summary.vertices = noded.vertices.size();
    summary.edges = noded.edges.size();
    PerFace<Int128> areas(subdivision.face_count, 0);
    std::vector<std::pair<FaceIndex, FaceIndex>> neighbours;
    for (const EdgeIndex e : noded.edges.indices()) {
        const GridPoint& a = noded.vertices[noded.edges[e].first];
        const GridPoint& b = noded.vertices[noded.edges[e].second];
        const Int128 area = twice_area({0, 0}, a, b);
        const FaceIndex left = subdivision.face[forward_half(e)], right = subdivision.face[backward_half(e)];
        areas[left] += area;
        areas[right] -= area;
        neighbours.emplace_back(left, right);
    }
    fill_areas_and_adjacency(summary, areas, neighbours);
    return summary;
}

}  // namespace rockslope::blockgen
