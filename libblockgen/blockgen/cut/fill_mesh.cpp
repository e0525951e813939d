#include "blockgen/cut/fill_mesh.hpp"

#include <algorithm>
#include <utility>

namespace rockslope::blockgen {

namespace {

NodeIndex origin_of(const NodedEdges& noded, HalfEdgeIndex h) {
    const EdgeEnds& edge = noded.edges[edge_of(h)];
    return is_forward(h) ? edge.first : edge.second;
}

/// Numbers things in the order in which they are first used.
template <class Index>
class UseOrder {
  public:
    explicit UseOrder(std::size_t count) : number_(count, Index::none()) {}

    Index number(Index old) const { return old.exists() ? number_[old] : old; }
    void use(Index old) {
        if (!old.exists() || number_[old].exists()) return;
        number_[old] = used_.size();
        used_.push_back(old);
    }
    /// What is used, in its new order.
    template <class T>
    IndexedVector<Index, T> select(const IndexedVector<Index, T>& all) const {
        IndexedVector<Index, T> selected;
        selected.reserve(used_.size());
        for (const Index old : used_) selected.push_back(all[old]);
        return selected;
    }

  private:
    IndexedVector<Index, Index> number_;
    std::vector<Index> used_;
};

class MeshFiller {
  public:
    MeshFiller(const NodedEdges& noded, const BlockRings& rings, const EdgeMarks& edges,
               const PerNode<char>& removed, const ThreadPool& pool)
        : noded_(noded),
          rings_(rings),
          edges_(edges),
          removed_(removed),
          pool_(pool),
          vertex_(noded.vertices.size(), VertexIndex::none()),
          joints_(edges.joints.size()),
          joint_materials_(edges.joint_materials.size()) {}

    FilledMesh run(RockMaterials materials) {
        number_in_order();
        BlockMesh& mesh = filled_.mesh;
        mesh.joints = joints_.select(edges_.joints);
        mesh.joint_materials = joint_materials_.select(edges_.joint_materials);
        mesh.block_rings.assign(rings_.first_ring.begin(), rings_.first_ring.end());
        mesh.block_material = std::move(materials.of_block);
        mesh.block_materials = std::move(materials.names);
        mesh.motion.assign(rings_.block_count(), BlockMotion::free);
        mesh.motion_name.resize(rings_.block_count());
        mesh.corners.resize(mesh.ring_corners.back());
        mesh.edge_marks.resize(mesh.ring_corners.back());
        const auto part = [&](std::size_t begin, std::size_t end) {
            Int128 twice = 0;
            for (const RingIndex r : indices<RingIndex>(begin, end)) twice += fill_ring(r);
            return twice;
        };
        filled_.twice_area = pool_.parallel_reduce(rings_.parts.size(), Int128{0}, part,
                                                   [](Int128 a, Int128 b) { return a + b; });
        return std::move(filled_);
    }

  private:
    RingSpan ring(RingIndex r) const {
        const BlockRings::Part& part = rings_.parts[r];
        return std::span(rings_.half_edges).subspan(part.begin, part.size);
    }

    /// Numbers vertices, joints and joint materials, and counts the corners of each ring.
    void number_in_order() {
        BlockMesh& mesh = filled_.mesh;
        mesh.vertices.reserve(noded_.vertices.size() - std::count(removed_.begin(), removed_.end(), 1));
        mesh.ring_corners.reserve(rings_.parts.size() + 1);
        for (const RingIndex r : rings_.parts.indices()) {
            CornerIndex corners = mesh.ring_corners.back();
            for (const HalfEdgeIndex h : ring(r)) {
                const NodeIndex node = origin_of(noded_, h);
                if (removed_[node]) continue;
                ++corners;
                if (!vertex_[node].exists()) {
                    vertex_[node] = mesh.vertices.size();
                    mesh.vertices.push_back(noded_.frame.position(noded_.vertices[node]));
                }
                const EdgeMark& mark = edges_.marks[edge_of(h)];
                joints_.use(mark.joint);
                joint_materials_.use(mark.joint_material);
            }
            mesh.ring_corners.push_back(corners);
        }
    }

    /// Fills the corners and marks of a ring. @return twice its area, in cells.
    Int128 fill_ring(RingIndex r) {
        BlockMesh& mesh = filled_.mesh;
        CornerIndex corner = mesh.ring_corners[r];
        const GridPoint *first = nullptr, *last = nullptr;
        Int128 twice = 0;
        for (const HalfEdgeIndex h : ring(r)) {
            const NodeIndex node = origin_of(noded_, h);
            if (removed_[node]) continue;
            const GridPoint* here = &noded_.vertices[node];
            if (first == nullptr) first = last = here;
            twice += twice_area(*first, *last, *here);
            last = here;
            const EdgeMark& mark = edges_.marks[edge_of(h)];
            mesh.edge_marks[corner] = {joint_materials_.number(mark.joint_material),
                                       joints_.number(mark.joint)};
            mesh.corners[corner++] = vertex_[node];
        }
        return twice;
    }

    const NodedEdges& noded_;
    const BlockRings& rings_;
    const EdgeMarks& edges_;
    const PerNode<char>& removed_;
    const ThreadPool& pool_;
    PerNode<VertexIndex> vertex_;
    UseOrder<JointIndex> joints_;
    UseOrder<JointMaterialIndex> joint_materials_;
    FilledMesh filled_;
};

}  // namespace

RockMaterials::RockMaterials(const CutContext& cut, const BlockRings& rings) {
    IndexedVector<RockIndex, BlockMaterialIndex> of_rock(cut.model.regions.size() + 1,
                                                         BlockMaterialIndex::none());
    of_block.reserve(rings.block_count());
    for (const FaceBlockIndex block : rings.block) {
        BlockMaterialIndex& material = of_rock[cut.faces.material[block]];
        if (!material.exists()) {
            const std::string& name = material_of(cut.faces, cut.model, block);
            material = std::find(names.begin(), names.end(), name) - names.begin();
            if (material == names.size()) names.push_back(name);
        }
        of_block.push_back(material);
    }
}

FilledMesh fill_mesh(const NodedEdges& noded, const BlockRings& rings, const EdgeMarks& edges,
                     const PerNode<char>& removed, RockMaterials materials, const ThreadPool& pool) {
    return MeshFiller(noded, rings, edges, removed, pool).run(std::move(materials));
}

}  // namespace rockslope::blockgen
