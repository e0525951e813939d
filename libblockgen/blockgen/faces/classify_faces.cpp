#include "blockgen/faces/classify_faces.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "common/base/disjoint_sets.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

namespace {

/// The outlines that contain each group of faces: one bit for each source that is not a joint, and the number
/// of parts of the domain (source 0).
class OutlineMembership {
  public:
    OutlineMembership(std::size_t faces, std::size_t outlines)
        : words_((outlines + 63) / 64), bits_(faces * words_, 0), parts_(faces, 0) {}

    bool test(FaceIndex face, SourceIndex outline) const {
        const std::size_t k = outline;
        return (bits_[row(face) + k / 64] >> (k % 64) & 1u) != 0;
    }
    /// The parts of the domain that contain a face: more than one where parts overlap.
    int parts(FaceIndex face) const { return parts_[face]; }
    void enter_part(FaceIndex face, int by) { parts_[face] += by; }
    void copy(FaceIndex from, FaceIndex to) {
        parts_[to] = parts_[from];
        for (std::size_t w = 0; w < words_; ++w) bits_[row(to) + w] = bits_[row(from) + w];
    }
    void toggle(FaceIndex face, SourceIndex outline) {
        const std::size_t k = outline;
        bits_[row(face) + k / 64] ^= std::uint64_t{1} << (k % 64);
    }

  private:
    std::size_t row(FaceIndex face) const { return std::size_t{face} * words_; }

    std::size_t words_;
    std::vector<std::uint64_t> bits_;
    PerFace<int> parts_;
};

bool has_outline(const NodedEdges& noded, EdgeIndex edge, const SourceTable& table) {
    // Sources are sorted, and those of outlines come first.
    return !table.is_joint(noded.sources[noded.first_source[edge]].source);
}

/// Groups of faces that no outline parts: the faces of a group lie in the same outlines.
class FaceGroups {
  public:
    FaceGroups(const NodedEdges& noded, const Subdivision& subdivision, const SourceTable& table)
        : group(subdivision.face_count) {
        DisjointSets sets(subdivision.face_count);
        for (const EdgeIndex e : noded.edges.indices()) {
            if (has_outline(noded, e, table))
                outline_edges.push_back(e);
            else
                sets.unite(subdivision.face[forward_half(e)], subdivision.face[backward_half(e)]);
        }
        // The root of a set is its smallest face.
        for (const FaceIndex f : group.indices()) {
            const FaceIndex root = sets.root(f);
            group[f] = root == f ? count++ : group[root];
        }
    }

    PerFace<FaceIndex> group;  ///< the unbounded face is in group 0
    std::int32_t count = 0;
    std::vector<EdgeIndex> outline_edges;
};

/// The outlines that contain each group.
OutlineMembership flood(const NodedEdges& noded, const Subdivision& subdivision, const SourceTable& table,
                        const FaceGroups& groups) {
    OutlineMembership in(groups.count, table.first_joint);
    PerFace<std::vector<HalfEdgeIndex>> by_group(groups.count);
    const auto group_of = [&](HalfEdgeIndex h) { return groups.group[subdivision.face[h]]; };
    for (const EdgeIndex e : groups.outline_edges)
        for (const HalfEdgeIndex h : {forward_half(e), backward_half(e)}) by_group[group_of(h)].push_back(h);
    PerFace<char> reached(groups.count, 0);
    std::vector<FaceIndex> front = {0};
    reached[0] = 1;
    while (!front.empty()) {
        const FaceIndex group = front.back();
        front.pop_back();
        for (const HalfEdgeIndex h : by_group[group]) {
            const FaceIndex other = group_of(twin(h));
            if (reached[other]) continue;
            reached[other] = 1;
            in.copy(group, other);
            // Parts run counter-clockwise: one that runs along the half-edge contains the face on its left.
            const bool forward = h == forward_half(edge_of(h));
            for (const EdgeSource& s : noded.sources_of(edge_of(h))) {
                if (s.source == 0)
                    in.enter_part(other, s.reversed == forward ? 1 : -1);
                else if (!table.is_joint(s.source))
                    in.toggle(other, s.source);
            }
            front.push_back(other);
        }
    }
    return in;
}

struct RockOfFace {
    bool is_rock = false;
    RockIndex material = 0;
    ExcavationIndex excavation = ExcavationIndex::none();
    int voids = 0;  ///< holes and tunnels that cover the face
};

RockOfFace rock_of(const OutlineMembership& in, FaceIndex face, const SlopeModel& model,
                   const SourceTable& table) {
    RockOfFace rock;
    for (const SourceIndex s : indices(table.first_hole, table.first_region)) rock.voids += in.test(face, s);
    for (const SourceIndex s : indices(table.first_tunnel, table.first_joint)) rock.voids += in.test(face, s);
    rock.is_rock = in.parts(face) > 0 && rock.voids == 0;
    for (const SourceIndex s : indices(table.first_region, table.first_excavation))
        if (in.test(face, s) && !model.regions[s - table.first_region].block_material.empty())
            rock.material = s - table.first_region + 1;
    const auto stage_of = [&](ExcavationIndex k) { return model.excavations[k].stage; };
    for (const SourceIndex s : indices(table.first_excavation, table.first_tunnel)) {
        const ExcavationIndex k = s - table.first_excavation;
        if (in.test(face, s) && (!rock.excavation.exists() || stage_of(k) < stage_of(rock.excavation)))
            rock.excavation = k;
    }
    return rock;
}

/// Twice the area of each face, in cells, without the holes of the unbounded face.
PerFace<Int128> twice_areas(const NodedEdges& noded, const Subdivision& subdivision) {
    PerFace<Int128> areas(subdivision.face_count, 0);
    for (const EdgeIndex e : noded.edges.indices()) {
        const auto& [a, b] = noded.edges[e];
        const Int128 area = twice_area({0, 0}, noded.vertices[a], noded.vertices[b]);
        areas[subdivision.face[forward_half(e)]] += area;
        areas[subdivision.face[backward_half(e)]] -= area;
    }
    return areas;
}

/// A point inside a bounded face: the middle of the widest stretch of a horizontal line through it, between
/// the two heights of vertices that are farthest apart.
Point point_inside(const NodedEdges& noded, const Subdivision& subdivision, FaceIndex face) {
    std::vector<std::pair<Point, Point>> edges;
    std::vector<double> heights;
    for (const EdgeIndex e : noded.edges.indices()) {
        const bool left = subdivision.face[forward_half(e)] == face;
        if (left == (subdivision.face[backward_half(e)] == face)) continue;
        const auto& [a, b] = noded.edges[e];
        edges.emplace_back(noded.frame.position(noded.vertices[a]), noded.frame.position(noded.vertices[b]));
        heights.insert(heights.end(), {edges.back().first.y, edges.back().second.y});
    }
    std::sort(heights.begin(), heights.end());
    double y = heights.front(), widest = 0;
    for (std::size_t k = 1; k < heights.size(); ++k)
        if (heights[k] - heights[k - 1] > widest) {
            widest = heights[k] - heights[k - 1];
            y = (heights[k] + heights[k - 1]) / 2;
        }
    std::vector<double> crossings;
    for (const auto& [a, b] : edges)
        if ((a.y < y) != (b.y < y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    std::sort(crossings.begin(), crossings.end());
    Point inside{edges.front().first.x, y};
    widest = 0;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        if (crossings[k + 1] - crossings[k] > widest) {
            widest = crossings[k + 1] - crossings[k];
            inside.x = (crossings[k] + crossings[k + 1]) / 2;
        }
    return inside;
}

/// The numbers, from 1, of the parts of the domain that contain a point, or that come nearest to it where the
/// overlap is as thin as the rounding to the grid.
std::vector<std::size_t> parts_at(const SlopeModel& model, const Point& p) {
    std::vector<std::size_t> parts;
    for (std::size_t k = 0; k <= model.further_outlines.size(); ++k)
        if (side_of_ring(k == 0 ? model.outline : model.further_outlines[k - 1], p) >= 0)
            parts.push_back(k + 1);
    return parts;
}

/// @throws InputError for the largest face that two parts of the domain contain.
void refuse_overlapping_parts(const NodedEdges& noded, const Subdivision& subdivision,
                              const FaceGroups& groups, const OutlineMembership& in,
                              const SlopeModel& model) {
    if (model.further_outlines.empty()) return;
    const PerFace<Int128> areas = twice_areas(noded, subdivision);
    FaceIndex largest = FaceIndex::none();
    Int128 twice_overlap = 0;
    for (const FaceIndex f : areas.indices()) {
        if (in.parts(groups.group[f]) < 2) continue;
        twice_overlap += areas[f];
        if (!largest.exists() || areas[f] > areas[largest]) largest = f;
    }
    if (!largest.exists()) return;
    const double area = static_cast<double>(twice_overlap) / 2 * noded.frame.step * noded.frame.step;
    const Point place = point_inside(noded, subdivision, largest);
    std::string which = "parts of the domain overlap";
    if (const auto parts = parts_at(model, place); parts.size() >= 2)
        which = "outline " + std::to_string(parts[1]) + " overlaps outline " + std::to_string(parts[0]);
    char text[96];
    std::snprintf(text, sizeof text, " at (%.10g, %.10g); overlaps make %.3g m2 in all", place.x, place.y,
                  area);
    throw InputError(model.outlines_location, which + text,
                     "parts of the domain that do not overlap; a hole as an inner ring or in holes");
}

/// Whether an outline contains a group of faces that lies in a part of the domain.
bool covers_domain(const OutlineMembership& in, std::size_t faces, SourceIndex outline) {
    const auto all = indices<FaceIndex>(faces);
    return std::any_of(all.begin(), all.end(),
                       [&](FaceIndex f) { return in.parts(f) > 0 && in.test(f, outline); });
}

void refuse_idle_hole(const OutlineMembership& in, std::size_t faces, const SlopeModel& model,
                      const SourceTable& table) {
    for (const SourceIndex s : indices(table.first_hole, table.first_region))
        if (!covers_domain(in, faces, s))
            throw InputError(model.holes_location,
                             "hole " + std::to_string(s - table.first_hole + 1) + " lies outside the outline",
                             "a hole that removes rock");
}

std::vector<std::size_t> idle_tunnels(const OutlineMembership& in, std::size_t faces,
                                      const SourceTable& table) {
    std::vector<std::size_t> idle;
    for (const SourceIndex s : indices(table.first_tunnel, table.first_joint))
        if (!covers_domain(in, faces, s)) idle.push_back(s - table.first_tunnel);
    return idle;
}

bool has_joint(const NodedEdges& noded, EdgeIndex edge, const SourceTable& table) {
    const auto sources = noded.sources_of(edge);
    return std::any_of(sources.begin(), sources.end(),
                       [&](const EdgeSource& s) { return table.is_joint(s.source); });
}

const std::string& name_of(const SlopeModel& model, RockIndex material) {
    return material == 0 ? model.block_material : model.regions[material - 1].block_material;
}

}  // namespace

const std::string& material_of(const FaceBlocks& faces, const SlopeModel& model, FaceBlockIndex block) {
    return name_of(model, faces.material[block]);
}

bool have_same_rock(const FaceBlocks& faces, const SlopeModel& model, FaceBlockIndex block,
                    FaceBlockIndex other) {
    return faces.excavation[block] == faces.excavation[other] &&
           material_of(faces, model, block) == material_of(faces, model, other);
}

FaceBlocks classify_faces(const NodedEdges& noded, const Subdivision& subdivision, const SlopeModel& model,
                          const SourceTable& table) {
    const FaceGroups groups(noded, subdivision, table);
    const OutlineMembership in = flood(noded, subdivision, table, groups);
    refuse_overlapping_parts(noded, subdivision, groups, in, model);
    PerFace<RockOfFace> rock_of_group;
    for (const FaceIndex g : indices<FaceIndex>(groups.count))
        rock_of_group.push_back(rock_of(in, g, model, table));
    const auto rock = [&](FaceIndex f) -> const RockOfFace& { return rock_of_group[groups.group[f]]; };

    DisjointSets sets(subdivision.face_count);
    for (const EdgeIndex e : groups.outline_edges) {
        const FaceIndex f = subdivision.face[forward_half(e)], g = subdivision.face[backward_half(e)];
        if (!rock(f).is_rock || !rock(g).is_rock) continue;
        if (!has_joint(noded, e, table) && rock(f).excavation == rock(g).excavation &&
            name_of(model, rock(f).material) == name_of(model, rock(g).material))
            sets.unite(f, g);
    }

    FaceBlocks result;
    result.idle_tunnels = idle_tunnels(in, groups.count, table);
    refuse_idle_hole(in, groups.count, model, table);
    for (const FaceIndex g : rock_of_group.indices())
        result.has_disjoint_voids =
            result.has_disjoint_voids && rock_of_group[g].voids <= (in.parts(g) > 0 ? 1 : 0);
    result.block.assign(subdivision.face_count, FaceBlocks::outside);
    for (const FaceIndex f : result.block.indices()) {
        if (!rock(f).is_rock) continue;
        // The root of a set is its smallest face.
        FaceBlockIndex& block = result.block[FaceIndex(sets.root(f))];
        if (block == FaceBlocks::outside) {
            block = result.material.size();
            result.material.push_back(rock(f).material);
            result.excavation.push_back(rock(f).excavation);
        }
        result.block[f] = block;
    }
    return result;
}

}  // namespace rockslope::blockgen
