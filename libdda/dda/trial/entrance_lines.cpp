#include "dda/trial/entrance_lines.hpp"

#include <algorithm>
#include <utility>

namespace rockslope::dda {

EntranceLines::EntranceLines(const StepProblem& problem, TrialContacts& trials)
    : p_(problem), trials_(trials) {
    int groups = 0;
    for (const ContactIndex k : p_.contacts.indices()) {
        groups = std::max(groups, p_.contacts[k].group + 1);
        if (p_.contacts[k].group >= 0 && !p_.contacts[k].inhibited) contacts_.push_back(k);
    }
    first_.resize(groups, ContactIndex::none());
}

/// First entrance, Eq. (28).
bool EntranceLines::select_first() {
    std::fill(first_.begin(), first_.end(), ContactIndex::none());
    for (const ContactIndex k : contacts_) {
        ContactIndex& first = first_[p_.contacts[k].group];
        const auto entrance_gap = [&](ContactIndex line) {
            return trials_[line].gap() + 2 * p_.contacts[line].inherited_penetration;
        };
        if (!first.exists() || entrance_gap(k) > entrance_gap(first)) first = k;
    }
    bool exchanged = false;
    for (const ContactIndex k : contacts_) {
        const ContactIndex first = first_[p_.contacts[k].group];
        const bool may_close = p_.contacts[first].line == p_.contacts[k].line;
        if (std::exchange(trials_[k].may_close, may_close) != may_close) exchanged = true;
    }
    return exchanged;
}

}  // namespace rockslope::dda
