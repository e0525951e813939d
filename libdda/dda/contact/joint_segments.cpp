#include "dda/contact/joint_segments.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dda/contact/detect.hpp"

namespace rockslope::dda {

namespace {

bool are_collinear(const Contact& a, const Contact& b) {
    if (a.joint_material != b.joint_material || a.length == 0 || b.length == 0) return false;
    if (std::abs(cross(a.normal, b.normal)) > parallel_tolerance) return false;
    // Corners that have come close, as at the two ends of a short overlap, are apart by what the joint has
    // dilated.
    const Vec2 between = b.point - a.point;
    return std::abs(between.dot(a.normal)) <=
           parallel_tolerance * std::max({between.norm(), a.length, b.length});
}

}  // namespace

JointSegments::JointSegments(const Model& model, std::span<const Contact> contacts) {
    std::vector<char> uses_segment_history;  // per joint material
    for (const JointMaterial& material : model.joint_materials)
        uses_segment_history.push_back(has_segment_history(material.law) ? 1 : 0);
    if (std::find(uses_segment_history.begin(), uses_segment_history.end(), 1) == uses_segment_history.end())
        return;
    const auto at = [&](int k) -> const Contact& { return contacts[static_cast<std::size_t>(k)]; };
    members_.reserve(contacts.size());
    offsets_.clear();
    std::vector<int> remaining, others;
    for (std::size_t k = 0; k < contacts.size();) {
        const std::pair<int, int> blocks = contacts[k].blocks();
        for (; k < contacts.size() && contacts[k].blocks() == blocks; ++k) {
            if (uses_segment_history[static_cast<std::size_t>(contacts[k].joint_material)] != 0)
                remaining.push_back(static_cast<int>(k));
        }
        while (!remaining.empty()) {
            offsets_.push_back(members_.size());
            const Contact& one = at(remaining.front());
            others.clear();
            for (const int other : remaining)
                (other == remaining.front() || are_collinear(one, at(other)) ? members_ : others)
                    .push_back(other);
            remaining.swap(others);
        }
    }
    offsets_.push_back(members_.size());
}

}  // namespace rockslope::dda
