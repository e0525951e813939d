#include "blockgen/mesh/check_mesh.hpp"

#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "common/base/input_error.hpp"
#include "common/geometry/point_text.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

namespace {

class MeshChecker {
  public:
    MeshChecker(const BlockMesh& mesh, const std::string& file_name) : mesh_(mesh), file_name_(file_name) {}

    void check(const ThreadPool& pool) const {
        check_arrays();
        for (const VertexIndex v : mesh_.vertices.indices())
            if (!std::isfinite(mesh_.vertices[v].x) || !std::isfinite(mesh_.vertices[v].y))
                fail("vertex " + std::to_string(v.value()) + " is not finite", "finite coordinates");
        // The first block at fault is told: ranges are ascending, and the first exception counts.
        pool.parallel_for(mesh_.block_count(), [&](std::size_t begin, std::size_t end) {
            std::vector<Ring> rings;
            for (const BlockIndex b : indices<BlockIndex>(begin, end)) check_block(b, rings);
        });
        for (const MeasuredPoint& point : mesh_.measured_points)
            check_point("measured point '" + point.name + "'", point.block, point.position);
        for (const Bolt& bolt : mesh_.bolts) {
            check_point("first end of bolt '" + bolt.name + "'", bolt.first_block, bolt.first);
            check_point("second end of bolt '" + bolt.name + "'", bolt.second_block, bolt.second);
            if (bolt.first == bolt.second) fail("bolt '" + bolt.name + "' has no length", "two points apart");
        }
        check_names();
    }

  private:
    [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
        throw InputError({file_name_}, what, expected);
    }

    template <class Part>
    static bool is_offsets(const std::vector<Part>& offsets, std::size_t total, std::int32_t step) {
        if (offsets.empty() || offsets.front() != 0 || offsets.back() != total) return false;
        for (std::size_t i = 1; i < offsets.size(); ++i)
            if (offsets[i] - offsets[i - 1] < step) return false;
        return true;
    }

    template <class Key, class T>
    static bool is_index_into(const IndexedVector<Key, T>& values, Key index) {
        return index.exists() && index < values.size();
    }

    void check_arrays() const {
        const std::size_t blocks = mesh_.block_rings.empty() ? 0 : mesh_.block_count();
        if (!is_offsets(mesh_.ring_corners, mesh_.corners.size(), 3) ||
            mesh_.edge_marks.size() != mesh_.corners.size())
            fail("the ring offsets do not divide the corners",
                 "three corners or more in each ring, one mark per edge");
        if (!is_offsets(mesh_.block_rings, mesh_.ring_corners.size() - 1, 1))
            fail("the block offsets do not divide the rings", "one ring or more in each block");
        if (mesh_.block_material.size() != blocks || mesh_.motion.size() != blocks ||
            mesh_.motion_name.size() != blocks)
            fail("the number of block materials or motions differs from the number of blocks",
                 "one material and one motion per block");
    }

    std::string block_text(BlockIndex b) const {
        const Point& p = mesh_.vertices[mesh_.ring(b, 0)[0]];
        return "block " + std::to_string(b.value()) + " at " + text_of(p);
    }

    void check_indices(BlockIndex b) const {
        if (!is_index_into(mesh_.block_materials, mesh_.block_material[b]))
            fail("block " + std::to_string(b.value()) + " has a block material out of range",
                 "an index into the block materials");
        for (std::size_t r = 0; r < mesh_.ring_count(b); ++r) {
            for (const VertexIndex vertex : mesh_.ring(b, r))
                if (!is_index_into(mesh_.vertices, vertex))
                    fail("block " + std::to_string(b.value()) + " has a vertex out of range",
                         "an index into the vertices");
            for (const EdgeMark& mark : mesh_.ring_marks(b, r)) {
                const bool free = mark == EdgeMark{};
                const bool joint_ok =
                    mark.joint == EdgeMark::no_joint || is_index_into(mesh_.joints, mark.joint);
                if (!free && (!joint_ok || !is_index_into(mesh_.joint_materials, mark.joint_material)))
                    fail("block " + std::to_string(b.value()) + " has an edge mark out of range",
                         "a joint material and a joint of the file");
            }
        }
    }

    void fill_rings(BlockIndex b, std::vector<Ring>& rings) const {
        rings.resize(mesh_.ring_count(b));
        for (std::size_t r = 0; r < rings.size(); ++r) {
            rings[r].clear();
            for (const VertexIndex vertex : mesh_.ring(b, r)) rings[r].push_back(mesh_.vertices[vertex]);
        }
    }

    /// @param rings work space.
    void check_block(BlockIndex b, std::vector<Ring>& rings) const {
        check_indices(b);
        fill_rings(b, rings);
        if (const auto fault = find_ring_fault(rings)) {
            const std::string edges = "edge " + std::to_string(fault->first_edge) + " of ring " +
                                      std::to_string(fault->first_ring) + " and edge " +
                                      std::to_string(fault->second_edge) + " of ring " +
                                      std::to_string(fault->second_ring);
            fail(block_text(b) + ": " + edges + " meet at " + text_of(fault->place), "simple rings");
        }
        if (!(twice_signed_area(rings[0]) > 0))
            fail(block_text(b) + ": the outer ring is clockwise or has no area",
                 "a counter-clockwise outer ring");
        for (std::size_t r = 1; r < rings.size(); ++r) check_hole(b, rings, r);
    }

    void check_hole(BlockIndex b, const std::vector<Ring>& rings, std::size_t r) const {
        const std::string name = block_text(b) + ": hole " + std::to_string(r);
        if (!(twice_signed_area(rings[r]) < 0)) fail(name + " is counter-clockwise", "clockwise holes");
        for (std::size_t other = 0; other < rings.size(); ++other) {
            if (other == r) continue;
            const int wanted = other == 0 ? 1 : -1;
            for (const Point& p : rings[r]) {
                const int side = side_of_ring(rings[other], p);
                if (side == 0) continue;
                if (side != wanted)
                    fail(name + (other == 0 ? " lies outside the outer ring" : " lies inside another hole"),
                         "holes inside the block that do not overlap");
                break;
            }
        }
    }

    void check_names() const {
        std::set<std::string_view> names;
        for (const MeasuredPoint& point : mesh_.measured_points)
            if (!names.insert(point.name).second)
                fail("there are two measured points '" + point.name + "'", "unique names");
    }

    void check_point(const std::string& name, BlockIndex block, const Point& p) const {
        if (!is_index_into(mesh_.block_material, block))
            fail(name + " has a block out of range", "an index into the blocks");
        std::vector<Ring> rings;
        fill_rings(block, rings);
        bool inside = side_of_ring(rings[0], p) >= 0;
        for (std::size_t r = 1; r < rings.size(); ++r) inside = inside && side_of_ring(rings[r], p) <= 0;
        if (!inside)
            fail(name + " at " + text_of(p) + " lies outside its block " + std::to_string(block.value()),
                 "a point inside the block");
    }

    const BlockMesh& mesh_;
    const std::string& file_name_;
};

}  // namespace

void check_mesh(const BlockMesh& mesh, const std::string& file_name, const ThreadPool& pool) {
    MeshChecker(mesh, file_name).check(pool);
}

}  // namespace rockslope::blockgen
