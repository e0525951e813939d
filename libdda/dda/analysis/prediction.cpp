#include "dda/analysis/prediction.hpp"

namespace rockslope::dda {

PerContact<const EvaluatedContact*> InitialGuess::match(ContactSpan<const Contact> new_contacts) const {
    PerContact<const EvaluatedContact*> found(new_contacts.size(), nullptr);
    ContactIndex k;
    for (const ContactIndex i : new_contacts.indices()) {
        while (k < contacts.size() && comes_before(contacts[k], new_contacts[i])) ++k;
        if (k < contacts.size() && !comes_before(new_contacts[i], contacts[k])) found[i] = &evaluated[k];
    }
    return found;
}

}  // namespace rockslope::dda
