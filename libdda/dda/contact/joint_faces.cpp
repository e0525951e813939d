#include "dda/contact/joint_faces.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>

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

/// A contact by the two blocks that it is between, in one number.
struct OfBlocks {
    std::uint64_t blocks = 0;
    int contact = 0;
    friend auto operator<=>(const OfBlocks&, const OfBlocks&) = default;
};

std::uint64_t blocks_of(const Contact& contact) {
    const auto [low, high] = std::minmax(contact.corner_block, contact.edge_block);
    return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high);
}

}  // namespace

JointFaces::JointFaces(const Model& model, std::span<const Contact> contacts) {
    std::vector<OfBlocks> by_blocks;
    by_blocks.reserve(contacts.size());
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Contact& contact = contacts[k];
        if (belongs_to_faces(model.joint_material_at(contact.joint_material).law))
            by_blocks.push_back({blocks_of(contact), static_cast<int>(k)});
    }
    std::sort(by_blocks.begin(), by_blocks.end());
    const auto at = [&](int k) -> const Contact& { return contacts[static_cast<std::size_t>(k)]; };
    members_.reserve(by_blocks.size());
    std::vector<int> left, others;
    first_.clear();
    for (auto begin = by_blocks.begin(); begin != by_blocks.end();) {
        const std::uint64_t blocks = begin->blocks;
        for (; begin != by_blocks.end() && begin->blocks == blocks; ++begin) left.push_back(begin->contact);
        while (!left.empty()) {
            first_.push_back(members_.size());
            const Contact& one = at(left.front());
            others.clear();
            for (const int k : left)
                (k == left.front() || on_one_line(one, at(k)) ? members_ : others).push_back(k);
            left.swap(others);
        }
    }
    first_.push_back(members_.size());
}

}  // namespace dda
