#include "blockgen/faces/classify_faces.hpp"

#include <algorithm>
#include <numeric>

#include "common/base/disjoint_sets.hpp"

namespace rockslope::blockgen {

namespace {

/// The outlines that contain each face: one bit for each source that is not a joint.
class OutlineMembership {
  public:
    OutlineMembership(std::size_t faces, std::size_t outlines)
        : words_((outlines + 63) / 64), bits_(faces * words_, 0) {}

    bool test(FaceIndex face, SourceIndex outline) const {
        const std::size_t k = outline;
        return (bits_[row(face) + k / 64] >> (k % 64) & 1u) != 0;
    }
    void copy(FaceIndex from, FaceIndex to) {
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
};

PerFace<std::vector<HalfEdgeIndex>> half_edges_by_face(const Subdivision& subdivision) {
    PerFace<std::vector<HalfEdgeIndex>> result(subdivision.face_count);
    for (const HalfEdgeIndex h : subdivision.face.indices()) result[subdivision.face[h]].push_back(h);
    return result;
}

OutlineMembership flood(const NodedEdges& noded, const Subdivision& subdivision, const SourceTable& table) {
    const std::size_t faces = subdivision.face_count;
    const auto by_face = half_edges_by_face(subdivision);
    OutlineMembership in(faces, table.first_joint);
    PerFace<char> reached(faces, 0);
    std::vector<FaceIndex> front = {0};
    reached[0] = 1;
    while (!front.empty()) {
        const FaceIndex face = front.back();
        front.pop_back();
        for (const HalfEdgeIndex h : by_face[face]) {
            const FaceIndex other = subdivision.face[twin(h)];
            if (reached[other]) continue;
            reached[other] = 1;
            in.copy(face, other);
            for (const EdgeSource& s : noded.sources_of(edge_of(h)))
                if (!table.is_joint(s.source)) in.toggle(other, s.source);
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
    rock.is_rock = in.test(face, 0) && rock.voids == 0;
    for (const SourceIndex s : indices(table.first_region, table.first_excavation))
        if (in.test(face, s)) rock.material = s - table.first_region + 1;
    const auto stage_of = [&](ExcavationIndex k) { return model.excavations[k].stage; };
    for (const SourceIndex s : indices(table.first_excavation, table.first_tunnel)) {
        const ExcavationIndex k = s - table.first_excavation;
        if (in.test(face, s) && (!rock.excavation.exists() || stage_of(k) < stage_of(rock.excavation)))
            rock.excavation = k;
    }
    return rock;
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
    const std::size_t faces = subdivision.face_count;
    const OutlineMembership in = flood(noded, subdivision, table);
    PerFace<RockOfFace> rock;
    for (const FaceIndex f : indices<FaceIndex>(faces)) rock.push_back(rock_of(in, f, model, table));

    DisjointSets sets(faces);
    for (const EdgeIndex e : noded.edges.indices()) {
        const FaceIndex f = subdivision.face[forward_half(e)], g = subdivision.face[backward_half(e)];
        if (!rock[f].is_rock || !rock[g].is_rock) continue;
        if (!has_joint(noded, e, table) && rock[f].excavation == rock[g].excavation &&
            name_of(model, rock[f].material) == name_of(model, rock[g].material))
            sets.unite(f, g);
    }

    FaceBlocks result;
    result.block.assign(faces, FaceBlocks::outside);
    PerFace<FaceBlockIndex> number(faces, FaceBlocks::outside);
    for (const FaceIndex f : rock.indices()) {
        result.has_disjoint_voids = result.has_disjoint_voids && rock[f].voids <= (in.test(f, 0) ? 1 : 0);
        if (!rock[f].is_rock) continue;
        FaceBlockIndex& block = number[sets.root(f)];
        if (block == FaceBlocks::outside) {
            block = result.material.size();
            result.material.push_back(rock[f].material);
            result.excavation.push_back(rock[f].excavation);
        }
        result.block[f] = block;
    }
    return result;
}

}  // namespace rockslope::blockgen
