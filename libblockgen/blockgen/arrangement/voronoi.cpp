#include "blockgen/arrangement/voronoi.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <tuple>

namespace rockslope::blockgen {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase>;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Structure>;

bool before(const Point& a, const Point& b) {
    return std::tuple(a.x, a.y) < std::tuple(b.x, b.y);
}

Point point_of(const Kernel::Point_2& p) {
    return {p.x(), p.y()};
}

/// Delaunay triangulation. The points are inserted in order of x, each located from the previous one, so that
/// the result does not depend on CGAL's random insertion order.
Triangulation triangulate(std::vector<Point>& points) {
    std::sort(points.begin(), points.end(), before);
    Triangulation result;
    Triangulation::Face_handle hint;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto vertex = result.insert(Kernel::Point_2(points[k].x, points[k].y), hint);
        vertex->info() = k;
        hint = vertex->face();
    }
    return result;
}

void relax(std::vector<Point>& points) {
    const Triangulation triangulation = triangulate(points);
    for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v) {
        Ring cell;
        bool bounded = true;
        auto face = triangulation.incident_faces(v);
        const auto first = face;
        if (face == nullptr) continue;
        do {
            bounded = bounded && !triangulation.is_infinite(face);
            if (bounded) cell.push_back(point_of(triangulation.dual(face)));
        } while (++face != first);
        if (!bounded) continue;
        const Point o = point_of(v->point());
        double area = 0, x = 0, y = 0;
        for (std::size_t k = 0; k < cell.size(); ++k) {
            const Point &a = cell[k], &b = cell[(k + 1) % cell.size()];
            const double cross = (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
            area += cross;
            x += cross * (a.x + b.x - 2 * o.x);
            y += cross * (a.y + b.y - 2 * o.y);
        }
        if (area > 0) points[v->info()] = {o.x + x / (3 * area), o.y + y / (3 * area)};
    }
}

}  // namespace

std::vector<std::pair<Point, Point>> voronoi_edges(std::vector<Point> points, int relaxation,
                                                   const Bounds& box) {
    for (int k = 0; k < relaxation; ++k) relax(points);
    const Triangulation triangulation = triangulate(points);
    std::vector<std::pair<Point, Point>> edges;
    if (triangulation.dimension() < 2) return edges;
    for (auto e = triangulation.finite_edges_begin(); e != triangulation.finite_edges_end(); ++e) {
        const auto face = e->first, other = face->neighbor(e->second);
        if (triangulation.is_infinite(face) || triangulation.is_infinite(other)) continue;
        Point a = point_of(triangulation.dual(face)), b = point_of(triangulation.dual(other));
        if (before(b, a)) std::swap(a, b);
        const auto inside = box.clip(a, {b.x - a.x, b.y - a.y});
        if (a == b || !inside || inside->first >= 1 || inside->second <= 0) continue;
        const auto at = [&](double t) { return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
        edges.emplace_back(inside->first > 0 ? at(inside->first) : a,
                           inside->second < 1 ? at(inside->second) : b);
    }
    std::sort(edges.begin(), edges.end(), [](const auto& e, const auto& f) {
        return std::tuple(e.first.x, e.first.y, e.second.x, e.second.y) <
               std::tuple(f.first.x, f.first.y, f.second.x, f.second.y);
    });
    return edges;
}

}  // namespace rockslope::blockgen
