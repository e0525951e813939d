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

/// A value that must be an integer; one that no face can have when it is not.
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

/// Replaces areas by ranks and puts the summary in order.
void finish(ArrangementSummary& cut, const std::vector<Int128>& area_of_face,
            const std::vector<std::pair<std::int32_t, std::int32_t>>& neighbours) {
    cut.twice_areas.assign(area_of_face.begin() + 1, area_of_face.end());
    std::sort(cut.twice_areas.begin(), cut.twice_areas.end());
    const auto rank = [&](std::int32_t face) {
        if (face == 0) return std::int32_t{-1};
        const auto place = std::lower_bound(cut.twice_areas.begin(), cut.twice_areas.end(),
                                            area_of_face[static_cast<std::size_t>(face)]);
        return static_cast<std::int32_t>(place - cut.twice_areas.begin());
    };
    for (const auto& [f, g] : neighbours) cut.adjacency.push_back(std::minmax({rank(f), rank(g)}));
    std::sort(cut.adjacency.begin(), cut.adjacency.end());
}

}  // namespace

ArrangementSummary arrange_exactly(const NodedEdges& noded) {
    const auto point_of = [&](std::int32_t v) {
        const GridPoint& p = noded.vertices[static_cast<std::size_t>(v)];
        return Kernel::Point_2(static_cast<double>(p.x), static_cast<double>(p.y));
    };
    std::vector<Traits::Curve_2> curves;
    for (const auto& [a, b] : noded.edges) curves.emplace_back(point_of(a), point_of(b));
    Arrangement arrangement;
    CGAL::insert(arrangement, curves.begin(), curves.end());

    ArrangementSummary cut;
    cut.vertices = arrangement.number_of_vertices();
    cut.edges = arrangement.number_of_edges();
    std::vector<Int128> areas(1, 0);
    for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f) {
        f->set_data(f->is_unbounded() ? 0 : static_cast<std::int32_t>(areas.size()));
        if (f->is_unbounded()) continue;
        Kernel::FT area = twice_ring_area(f->outer_ccb());
        for (auto hole = f->inner_ccbs_begin(); hole != f->inner_ccbs_end(); ++hole)
            area += twice_ring_area(*hole);
        areas.push_back(integer_of(area));
    }
    std::vector<std::pair<std::int32_t, std::int32_t>> neighbours;
    for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e)
        neighbours.emplace_back(e->face()->data(), e->twin()->face()->data());
    finish(cut, areas, neighbours);
    return cut;
}

ArrangementSummary summarize(const NodedEdges& noded, const Subdivision& subdivision) {
    ArrangementSummary cut;
    cut.vertices = noded.vertices.size();
    cut.edges = noded.edges.size();
    std::vector<Int128> areas(static_cast<std::size_t>(subdivision.face_count), 0);
    std::vector<std::pair<std::int32_t, std::int32_t>> neighbours;
    for (std::size_t e = 0; e < noded.edges.size(); ++e) {
        const GridPoint& a = noded.vertices[static_cast<std::size_t>(noded.edges[e].first)];
        const GridPoint& b = noded.vertices[static_cast<std::size_t>(noded.edges[e].second)];
        const Int128 area = twice_area({0, 0}, a, b);
        areas[static_cast<std::size_t>(subdivision.face[2 * e])] += area;
        areas[static_cast<std::size_t>(subdivision.face[2 * e + 1])] -= area;
        neighbours.emplace_back(subdivision.face[2 * e], subdivision.face[2 * e + 1]);
    }
    finish(cut, areas, neighbours);
    return cut;
}

}  // namespace rockslope::blockgen
