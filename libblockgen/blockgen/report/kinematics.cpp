#include "blockgen/report/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "blockgen/mesh/measures.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

namespace {

/// An edge of a block that is not free: a joint, a contact of materials, or a fixed side of the domain.
struct Face {
    Point along;           ///< unit vector, with the block on its left
    double tolerance = 0;  ///< d.n may be negative by this much, because snapping rotates the edge
    double offset = 0;     ///< distance of its line from the first vertex of its ring, m
    double length = 0;     ///< m
    JointIndex joint;      ///< none for a fixed side or a change of material
    double friction = 0;   ///< tangent of the friction angle
};

double dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y;
}

Point inward(const Face& face) {
    return {-face.along.y, face.along.x};
}

class BlockScreen {
  public:
    BlockScreen(const BlockMesh& mesh, const KinematicScreen& screen, const Bounds& bounds, double grid)
        : mesh_(mesh), screen_(screen), bounds_(bounds), grid_(grid) {
        for (const std::string& name : mesh.joint_materials) {
            const auto own = screen.friction_of_material.find(name);
            friction_.push_back(
                std::tan(own == screen.friction_of_material.end() ? screen.friction_angle : own->second));
        }
    }

    KinematicReport run() {
        KinematicReport report;
        for (const BlockIndex b : mesh_.blocks()) {
            KeyBlock key;
            key.block = b;
            key.mode = mode_of(b, key);
            report.mode.push_back(key.mode);
            if (key.mode < BlockMode::falling) continue;
            key.area = block_area(mesh_, b);
            report.blocks.push_back(key);
        }
        std::sort(report.blocks.begin(), report.blocks.end(), [](const KeyBlock& a, const KeyBlock& b) {
            return std::tuple(a.factor_of_safety, a.block) < std::tuple(b.factor_of_safety, b.block);
        });
        return report;
    }

  private:
    bool is_fixed_side(const Point& a, const Point& b) const {
        const double reach = 4 * grid_;
        const auto both = [&](const auto& is_there) { return is_there(a) && is_there(b); };
        for (const std::string& side : screen_.fixed_sides) {
            if (side == "bottom" && both([&](const Point& p) { return p.y <= bounds_.low.y + reach; }))
                return true;
            if (side == "top" && both([&](const Point& p) { return p.y >= bounds_.high.y - reach; }))
                return true;
            if (side == "left" && both([&](const Point& p) { return p.x <= bounds_.low.x + reach; }))
                return true;
            if (side == "right" && both([&](const Point& p) { return p.x >= bounds_.high.x - reach; }))
                return true;
        }
        return false;
    }

    double friction_of(JointMaterialIndex joint_material) const {
        return joint_material.exists() ? friction_[joint_material] : std::tan(screen_.friction_angle);
    }

    /// Collects the faces of a block. @return whether the block has a free edge.
    bool collect_faces(BlockIndex b) {
        faces_.clear();
        bool free = false;
        for (std::size_t r = 0; r < mesh_.ring_count(b); ++r) {
            const Ring ring = ring_points(mesh_, b, r);
            const auto marks = mesh_.ring_marks(b, r);
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const Point &p = ring[k], &q = ring[(k + 1) % ring.size()];
                if (marks[k] == EdgeMark{} && !is_fixed_side(p, q)) {
                    free = true;
                    continue;
                }
                Face face;
                face.length = std::hypot(q.x - p.x, q.y - p.y);
                face.along = {(q.x - p.x) / face.length, (q.y - p.y) / face.length};
                face.tolerance = 1e-9 + 4 * grid_ / face.length;
                face.offset = dot(inward(face), {p.x - ring[0].x, p.y - ring[0].y});
                face.joint = marks[k].joint;
                face.friction = friction_of(marks[k].joint_material);
                faces_.push_back(face);
            }
        }
        return free;
    }

    bool may_move(const Point& d) const {
        return std::all_of(faces_.begin(), faces_.end(),
                           [&](const Face& f) { return dot(d, inward(f)) >= -f.tolerance; });
    }

    BlockMode mode_of(BlockIndex b, KeyBlock& key) {
        if (mesh_.motion[b] != BlockMotion::free || !collect_faces(b)) return BlockMode::enclosed;
        const Point down{0, -1};
        if (may_move(down) && std::none_of(faces_.begin(), faces_.end(), [&](const Face& f) {
                return std::abs(dot(down, inward(f))) <= f.tolerance && f.joint.exists();
            })) {
            key.direction = down;
            return BlockMode::falling;
        }
        const Face* sliding_face = nullptr;
        bool removable = false;
        for (const Face& face : faces_)
            for (const double sign : {1.0, -1.0}) {
                const Point d{sign * face.along.x, sign * face.along.y};
                if (!may_move(d)) continue;
                removable = true;
                const double descent = -d.y;
                const bool steeper = sliding_face == nullptr ? descent > face.tolerance
                                                             : descent > -key.direction.y + face.tolerance;
                if (!steeper) continue;
                key.direction = d;
                sliding_face = &face;
            }
        if (sliding_face == nullptr) return removable ? BlockMode::stable : BlockMode::tapered;
        return slide(key);
    }

    /// The joint along which the block slides, and the factor of safety. The joints below the block carry the
    /// normal component of the weight, divided between them in proportion to their lengths.
    BlockMode slide(KeyBlock& key) const {
        // A joint below the block is preferred, then the longest joint. In a vertical slot no joint is below.
        std::pair<bool, double> best{false, 0};
        double bearing_length = 0, friction_sum = 0;
        std::vector<double> offsets;
        for (const Face& face : faces_) {
            const double turn = face.along.x * key.direction.y - face.along.y * key.direction.x;
            if (std::abs(turn) > 2 * face.tolerance) continue;
            const double offset = face.offset * (dot(face.along, key.direction) > 0 ? 1 : -1);
            if (std::none_of(offsets.begin(), offsets.end(),
                             [&](double o) { return std::abs(o - offset) < 16 * grid_; }))
                offsets.push_back(offset);
            const bool carries = inward(face).y > 0;
            if (carries) bearing_length += face.length, friction_sum += face.length * face.friction;
            const std::pair<bool, double> candidate{carries, face.length};
            if (candidate <= best) continue;
            best = candidate;
            key.joint = face.joint;
        }
        const double driving_component = -key.direction.y, normal_component = std::abs(key.direction.x);
        key.factor_of_safety =
            bearing_length > 0 ? friction_sum / bearing_length * normal_component / driving_component : 0;
        return offsets.size() > 1 ? BlockMode::sliding_two_faces : BlockMode::sliding;
    }

    const BlockMesh& mesh_;
    const KinematicScreen& screen_;
    Bounds bounds_;
    double grid_;
    PerJointMaterial<double> friction_;  ///< tangent of its friction angle
    std::vector<Face> faces_;
};

}  // namespace

KinematicReport screen_blocks(const BlockMesh& mesh, const KinematicScreen& screen, const Bounds& bounds,
                              double grid) {
    return BlockScreen(mesh, screen, bounds, grid).run();
}

}  // namespace rockslope::blockgen
