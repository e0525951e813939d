#include "dda/contact/joint_faces.hpp"

#include <algorithm>
#include <cmath>
#include <compare>

#include "dda/contact/by_owner.hpp"
#include "dda/contact/detect.hpp"

namespace dda {

namespace {

bool on_one_line(const Contact& a, const Contact& b) {
    if (a.joint_material != b.joint_material || a.length == 0 || b.length == 0) return false;
    if (std::abs(cross(a.normal, b.normal)) > parallel_tolerance) return false;
    // Corners that have come close, as at the two ends of a short overlap, are apart by what the joint has
    // dilated.
    const Vec2 between = b.point - a.point;
    return std::abs(between.dot(a.normal)) <=
           parallel_tolerance * std::max({between.norm(), a.length, b.length});
}

/// A contact by the higher of the two blocks that it is between.
struct OfHigher {
    int block = 0;
    int contact = 0;
    friend auto operator<=>(const OfHigher&, const OfHigher&) = default;
};

}  // namespace

JointFaces::JointFaces(const Model& model, std::span<const Contact> contacts) {
    std::vector<char> rough;  // per joint material
    for (const JointMaterial& material : model.joint_materials)
        rough.push_back(belongs_to_faces(material.law) ? 1 : 0);
    std::vector<int> of_faces, lower;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Contact& contact = contacts[k];
        if (rough[static_cast<std::size_t>(contact.joint_material)] == 0) continue;
        of_faces.push_back(static_cast<int>(k));
        lower.push_back(std::min(contact.corner_block, contact.edge_block));
    }
    if (of_faces.empty()) return;
    const auto at = [&](int k) -> const Contact& { return contacts[static_cast<std::size_t>(k)]; };
    members_.reserve(of_faces.size());
    first_.clear();
    std::vector<OfHigher> of_lower;
    std::vector<int> left, others;
    const int blocks = *std::max_element(lower.begin(), lower.end()) + 1;
    const ByOwner by_lower(blocks, lower);
    for (int block = 0; block < blocks; ++block) {
        of_lower.clear();
        for (const int place : by_lower.of(block)) {
            const int k = of_faces[static_cast<std::size_t>(place)];
            of_lower.push_back({std::max(at(k).corner_block, at(k).edge_block), k});
        }
        std::sort(of_lower.begin(), of_lower.end());
        for (auto begin = of_lower.begin(); begin != of_lower.end();) {
            const int other_block = begin->block;
            for (; begin != of_lower.end() && begin->block == other_block; ++begin)
                left.push_back(begin->contact);
            while (!left.empty()) {
                first_.push_back(members_.size());
                const Contact& one = at(left.front());
                others.clear();
                for (const int k : left)
                    (k == left.front() || on_one_line(one, at(k)) ? members_ : others).push_back(k);
                left.swap(others);
            }
        }
    }
    first_.push_back(members_.size());
}

}  // namespace dda
