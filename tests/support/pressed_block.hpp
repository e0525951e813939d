#pragma once

#include <span>
#include <vector>

#include "dda/path/limited_forces.hpp"

namespace rockslope::pressed_block {

/// A block on a rigid plane, held by 1e3 N/m in each unknown, pressed by 100 N and pushed along the
/// plane; friction is half the normal force. The contact can be moved away from it by its origin.
struct PressedBlock {
    dda::BlockPair rows{dda::RowIndex(0), dda::RowIndex::none()};
    dda::LimitedContact contact;
    dda::BaseSystem base;
    std::vector<dda::ContactSprings> springs = std::vector<dda::ContactSprings>(1);
    dda::RowContacts row_contacts;

    explicit PressedBlock(double push) {
        contact.rows = &rows;
        contact.opening = {0, 1};
        contact.shearing = {1, 0};
        contact.normal_stiffness = 1e6;
        contact.shear_stiffness = 4e5;
        contact.forward = contact.backward = {0, 0.5};
        base.stiffness.push_back(1e3 * dda::Mat6::Identity());
        base.load.push_back(dda::Vec6::Zero());
        base.load[dda::RowIndex(0)].head<2>() << push, -100;
        springs[0].rows = rows;
        row_contacts.find(1, springs);
    }
    PressedBlock(const PressedBlock&) = delete;
    PressedBlock& operator=(const PressedBlock&) = delete;

    dda::LimitedStep step() const { return {base, row_contacts, std::span(&contact, 1)}; }
};

}  // namespace rockslope::pressed_block
