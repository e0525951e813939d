#include "blockgen/arrangement/arrange.hpp"

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_non_caching_segment_basic_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace rockslope::blockgen {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Arr_non_caching_segment_basic_traits_2<Kernel>;
using Dcel = CGAL::Arr_extended_dcel<Traits, std::int32_t, std::int32_t, std::int32_t>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;

Traits::Point_2 point_of(const GridPoint& p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

NodeIndex vertex_index(const NodedEdges& noded, const Traits::Point_2& p) {
    const GridPoint place{static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y())};
    const auto found = std::lower_bound(noded.vertices.begin(), noded.vertices.end(), place);
    if (found == noded.vertices.end() || *found != place)
        throw std::logic_error("the arrangement created a vertex that is not a noded vertex");
    return found - noded.vertices.begin();
}

EdgeIndex edge_index(const NodedEdges& noded, const EdgeEnds& ends) {
    const auto found = std::lower_bound(noded.edges.begin(), noded.edges.end(), ends);
    if (found == noded.edges.end() || *found != ends)
        throw std::logic_error("the arrangement created an edge that is not a noded edge");
    return found - noded.edges.begin();
}

void number_features(const NodedEdges& noded, Arrangement& arrangement) {
    for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v)
        v->set_data(vertex_index(noded, v->point()).value());
    for (auto h = arrangement.halfedges_begin(); h != arrangement.halfedges_end(); ++h) {
        const NodeIndex a = h->source()->data(), b = h->target()->data();
        const HalfEdgeIndex half =
            a < b ? forward_half(edge_index(noded, {a, b})) : backward_half(edge_index(noded, {b, a}));
        h->set_data(half.value());
    }
    std::int32_t next_face = 1;
    for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f)
        f->set_data(f->is_unbounded() ? 0 : next_face++);
}

}  // namespace

Subdivision arrange(const NodedEdges& noded) {
    std::vector<Traits::X_monotone_curve_2> curves;
    curves.reserve(noded.edges.size());
    for (const auto& [a, b] : noded.edges)
        curves.emplace_back(point_of(noded.vertices[a]), point_of(noded.vertices[b]));
    Arrangement arrangement;
    CGAL::insert_non_intersecting_curves(arrangement, curves.begin(), curves.end());
    if (arrangement.number_of_edges() != noded.edges.size())
        throw std::logic_error("the arrangement has " + std::to_string(arrangement.number_of_edges()) +
                               " edges, expected " + std::to_string(noded.edges.size()));
    number_features(noded, arrangement);

    Subdivision result;
    result.face_count = arrangement.number_of_faces();
    result.next.resize(2 * noded.edges.size());
    result.face.resize(2 * noded.edges.size());
    for (auto h = arrangement.halfedges_begin(); h != arrangement.halfedges_end(); ++h) {
        const HalfEdgeIndex k = h->data();
        result.next[k] = h->next()->data();
        result.face[k] = h->face()->data();
    }
    return result;
}

}  // namespace rockslope::blockgen
