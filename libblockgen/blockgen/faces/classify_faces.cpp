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

    bool test(std::size_t face, std::int32_t outline) const {
        const std::size_t k = outline;
        return (bits_[face * words_ + k / 64] >> (k % 64) & 1u) != 0;
    }
    void copy(std::size_t from, std::size_t to) {
        for (std::size_t w = 0; w < words_; ++w) bits_[to * words_ + w] = bits_[from * words_ + w];
    }
    void toggle(std::size_t face, std::int32_t outline) {
        const std::size_t k = outline;
        bits_[face * words_ + k / 64] ^= std::uint64_t{1} << (k % 64);
    }

  private:
    std::size_t words_;
    std::vector<std::uint64_t> bits_;
};

std::vector<std::vector<std::int32_t>> half_edges_by_face(const Subdivision& subdivision) {
    std::vector<std::vector<std::int32_t>> result(subdivision.face_count);
    for (std::size_t h = 0; h < subdivision.face.size(); ++h) result[subdivision.face[h]].push_back(h);
    return result;
}

OutlineMembership flood(const NodedEdges& noded, const Subdivision& subdivision, const SourceTable& table) {
    const std::size_t faces = subdivision.face_count;
    const auto by_face = half_edges_by_face(subdivision);
    OutlineMembership in(faces, table.first_joint);
    std::vector<char> reached(faces, 0);
    std::vector<std::size_t> front = {0};
    reached[0] = 1;
    while (!front.empty()) {
        const std::size_t face = front.back();
        front.pop_back();
        for (const std::int32_t h : by_face[face]) {
            const std::size_t other = subdivision.face[h ^ 1];
            if (reached[other]) continue;
            reached[other] = 1;
            in.copy(face, other);
            for (const EdgeSource& s : noded.sources_of(h / 2))
                if (!table.is_joint(s.source)) in.toggle(other, s.source);
            front.push_back(other);
        }
    }
    return in;
}

struct RockOfFace {
    bool is_rock = false;
    std::int32_t material = 0;
    std::int32_t excavation = -1;
    int voids = 0;  ///< holes and tunnels that cover the face
};

RockOfFace rock_of(const OutlineMembership& in, std::size_t face, const SlopeModel& model,
                   const SourceTable& table) {
    RockOfFace rock;
    for (std::int32_t s = table.first_hole; s < table.first_region; ++s) rock.voids += in.test(face, s);
    for (std::int32_t s = table.first_tunnel; s < table.first_joint; ++s) rock.voids += in.test(face, s);
    rock.is_rock = in.test(face, 0) && rock.voids == 0;
    for (std::int32_t s = table.first_region; s < table.first_excavation; ++s)
        if (in.test(face, s)) rock.material = s - table.first_region + 1;
    const auto stage_of = [&](std::int32_t k) { return model.excavations[k].stage; };
    for (std::int32_t s = table.first_excavation; s < table.first_tunnel; ++s) {
        const std::int32_t k = s - table.first_excavation;
        if (in.test(face, s) && (rock.excavation < 0 || stage_of(k) < stage_of(rock.excavation)))
            rock.excavation = k;
    }
    return rock;
}

bool has_joint(const NodedEdges& noded, std::size_t edge, const SourceTable& table) {
    const auto sources = noded.sources_of(edge);
    return std::any_of(sources.begin(), sources.end(),
                       [&](const EdgeSource& s) { return table.is_joint(s.source); });
}

const std::string& name_of(const SlopeModel& model, std::int32_t material) {
    return material == 0 ? model.block_material : model.regions[material - 1].block_material;
}

}  // namespace

const std::string& material_of(const FaceBlocks& faces, const SlopeModel& model, std::size_t block) {
    return name_of(model, faces.material[block]);
}

bool have_same_rock(const FaceBlocks& faces, const SlopeModel& model, std::size_t block, std::size_t other) {
    return faces.excavation[block] == faces.excavation[other] &&
           material_of(faces, model, block) == material_of(faces, model, other);
}

FaceBlocks classify_faces(const NodedEdges& noded, const Subdivision& subdivision, const SlopeModel& model,
                          const SourceTable& table) {
    const std::size_t faces = subdivision.face_count;
    const OutlineMembership in = flood(noded, subdivision, table);
    std::vector<RockOfFace> rock;
    for (std::size_t f = 0; f < faces; ++f) rock.push_back(rock_of(in, f, model, table));

    DisjointSets sets(faces);
    for (std::size_t e = 0; e < noded.edges.size(); ++e) {
        const std::size_t f = subdivision.face[2 * e], g = subdivision.face[2 * e + 1];
        if (!rock[f].is_rock || !rock[g].is_rock) continue;
        if (!has_joint(noded, e, table) && rock[f].excavation == rock[g].excavation &&
            name_of(model, rock[f].material) == name_of(model, rock[g].material))
            sets.unite(f, g);
    }

    FaceBlocks result;
    result.block.assign(faces, FaceBlocks::outside);
    std::vector<std::int32_t> number(faces, FaceBlocks::outside);
    for (std::size_t f = 0; f < faces; ++f) {
        result.has_disjoint_voids = result.has_disjoint_voids && rock[f].voids <= (in.test(f, 0) ? 1 : 0);
        if (!rock[f].is_rock) continue;
        std::int32_t& block = number[sets.root(f)];
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
