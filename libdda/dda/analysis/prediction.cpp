#include "dda/analysis/prediction.hpp"

namespace rockslope::dda {

std::vector<const EvaluatedContact*> InitialGuess::match(std::span<const Contact> new_contacts) const {
    std::vector<const EvaluatedContact*> found(new_contacts.size(), nullptr);
    std::size_t k = 0;
    for (std::size_t other = 0; other < new_contacts.size(); ++other) {
        while (k < contacts.size() && comes_before(contacts[k], new_contacts[other])) ++k;
        if (k < contacts.size() && !comes_before(new_contacts[other], contacts[k]))
            found[other] = &evaluated[k];
    }
    return found;
}

}  // namespace rockslope::dda
