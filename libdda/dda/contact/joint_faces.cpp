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
    std::vector<char> rough;  // per joint material
    for (const JointMaterial& material : model.joint_materials)
        rough.push_back(belongs_to_faces(material.law) ? 1 : 0);
    if (std::find(rough.begin(), rough.end(), 1) == rough.end()) return;
    const auto at = [&](int k) -> const Contact& { return contacts[static_cast<std::size_t>(k)]; };
    members_.reserve(contacts.size());
    first_.clear();
    std::vector<int> left, others;
    for (std::size_t k = 0; k < contacts.size();) {
        const std::pair<int, int> blocks = contacts[k].blocks();
        for (; k < contacts.size() && contacts[k].blocks() == blocks; ++k) {
            if (rough[static_cast<std::size_t>(contacts[k].joint_material)] != 0)
                left.push_back(static_cast<int>(k));
        }
        while (!left.empty()) {
            first_.push_back(members_.size());
            const Contact& one = at(left.front());
            others.clear();
            for (const int other : left)
                (other == left.front() || on_one_line(one, at(other)) ? members_ : others).push_back(other);
            left.swap(others);
        }
    }
    first_.push_back(members_.size());
}

}  // namespace dda
