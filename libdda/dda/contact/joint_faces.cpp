#include "dda/contact/joint_faces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

}  // namespace

JointFaces::JointFaces(const Model& model, std::span<const Contact> contacts) {
    std::vector<std::pair<std::pair<int, int>, int>> by_blocks;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Contact& contact = contacts[k];
        if (belongs_to_faces(model.joint_material_at(contact.joint_material).law))
            by_blocks.push_back({std::minmax(contact.corner_block, contact.edge_block), static_cast<int>(k)});
    }
    std::sort(by_blocks.begin(), by_blocks.end());
    const auto at = [&](int k) -> const Contact& { return contacts[static_cast<std::size_t>(k)]; };
    std::vector<int> left;
    first_.clear();
    for (auto begin = by_blocks.begin(); begin != by_blocks.end();) {
        const auto end = std::find_if(begin, by_blocks.end(),
                                      [&](const auto& other) { return other.first != begin->first; });
        for (; begin != end; ++begin) left.push_back(begin->second);
        while (!left.empty()) {
            first_.push_back(members_.size());
            const Contact& one = at(left.front());
            const auto others = std::stable_partition(left.begin() + 1, left.end(),
                                                      [&](int other) { return on_one_line(one, at(other)); });
            members_.insert(members_.end(), left.begin(), others);
            left.erase(left.begin(), others);
        }
    }
    first_.push_back(members_.size());
}

}  // namespace dda
