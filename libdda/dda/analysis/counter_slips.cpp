#include "dda/analysis/counter_slips.hpp"

#include "dda/trial/joint_motion.hpp"

namespace rockslope::dda {

namespace {

JointRecord record_of(const Model& model, const Contact& contact, const JointHistory& history) {
    return record(model.joint_material_at(contact.joint_material).law, history);
}

/// Whether the counter-slip of `before` goes on in `after`, or has become a reversal there.
bool goes_on(const JointRecord& before, const JointRecord& after) {
    const CounterSlip& was = before.counter_slip;
    const CounterSlip& is = after.counter_slip;
    if (is.amount < was.amount || (was.counted && !is.counted)) return false;
    return after.reversals - before.reversals == (is.counted && !was.counted ? 1 : 0);
}

JointCounterSlip at_segment(std::span<const ContactIndex> members, ContactSpan<const Contact> contacts,
                            const CounterSlip& slip) {
    const Contact& one = contacts[members.front()];
    const auto [first, second] = one.blocks();
    Vec2 sum = Vec2::Zero();
    for (const ContactIndex k : members) sum += contacts[k].point;
    return {first, second, one.joint_material, sum / static_cast<double>(members.size()), slip};
}

}  // namespace

std::vector<JointCounterSlip> ended_counter_slips(const Model& model, const JointSegments& segments,
                                                  ContactSpan<const Contact> before,
                                                  ContactSpan<const Contact> after) {
    std::vector<JointCounterSlip> ended;
    for (std::size_t segment = 0; segment < segments.count(); ++segment) {
        const auto members = segments.contacts_of(segment);
        const Contact& one = after[members.front()];
        const JointHistory& continued = continued_history(members, before);
        const JointRecord was = record_of(model, one, continued);
        if (!(was.counter_slip.amount > 0) || goes_on(was, record_of(model, one, one.history))) continue;
        ended.push_back(at_segment(members, after, was.counter_slip));
    }
    return ended;
}

std::vector<JointCounterSlip> present_counter_slips(const Model& model, ContactSpan<const Contact> contacts) {
    std::vector<JointCounterSlip> present;
    const JointSegments segments(model, contacts);
    for (std::size_t segment = 0; segment < segments.count(); ++segment) {
        const auto members = segments.contacts_of(segment);
        const JointHistory& history = continued_history(members, contacts);
        const CounterSlip slip = record_of(model, contacts[members.front()], history).counter_slip;
        if (slip.amount > 0) present.push_back(at_segment(members, contacts, slip));
    }
    return present;
}

bool wears_by_reversals(const Model& model) {
    return std::any_of(model.joint_materials.begin(), model.joint_materials.end(),
                       [](const JointMaterial& material) {
                           const JointHistory fresh = fresh_history(material.law, true);
                           return record(material.law, fresh).counter_slip.least > 0;
                       });
}

}  // namespace rockslope::dda
