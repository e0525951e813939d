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
    // The contacts at the two ends of a short overlap are close to each other, and dilation separates them
    // normal to the joint: the tolerance therefore uses the lengths too.
    const Vec2 between = b.point - a.point;
    return std::abs(between.dot(a.normal)) <=
           parallel_tolerance * std::max({between.norm(), a.length, b.length});
}

}  // namespace

JointSegments::JointSegments(const Model& model, ContactSpan<const Contact> contacts) {
    IndexedVector<JointMaterialIndex, char> uses_segment_history;
    for (const JointMaterial& material : model.joint_materials)
        uses_segment_history.push_back(has_segment_history(material.law) ? 1 : 0);
    if (std::find(uses_segment_history.begin(), uses_segment_history.end(), 1) == uses_segment_history.end())
        return;
    members_.reserve(contacts.size());
    offsets_.clear();
    std::vector<ContactIndex> remaining, others;
    for (ContactIndex k; k < contacts.size();) {
        const auto blocks = contacts[k].blocks();
        for (; k < contacts.size() && contacts[k].blocks() == blocks; ++k) {
            if (uses_segment_history[contacts[k].joint_material] != 0) remaining.push_back(k);
        }
        while (!remaining.empty()) {
            offsets_.push_back(members_.size());
            const Contact& one = contacts[remaining.front()];
            others.clear();
            for (const ContactIndex other : remaining)
                (other == remaining.front() || are_collinear(one, contacts[other]) ? members_ : others)
                    .push_back(other);
            remaining.swap(others);
        }
    }
    offsets_.push_back(members_.size());
}

}  // namespace rockslope::dda
