#include "dda/analysis/deepest_contact.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

void note_deepest_contact(const Model& model, State& state) {
    DeepestContact& deepest = state.deepest_contact;
    for (const Contact& contact : state.contacts.contacts) {
        if (contact.state == ContactState::open || model.is_augmented(contact.joint_material)) continue;
        const double area = std::min(state.blocks.moments[contact.corner_block].area,
                                     state.blocks.moments[contact.edge_block].area);
        const double least = deepest.share * std::sqrt(area);
        if (!(-contact.gap > least)) continue;
        deepest = {-contact.gap / std::sqrt(area), -contact.gap, state.time, contact.corner_block,
                   contact.edge_block};
    }
}

}  // namespace rockslope::dda
