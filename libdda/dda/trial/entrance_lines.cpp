#include "dda/trial/entrance_lines.hpp"

#include <algorithm>
#include <utility>

namespace rockslope::dda {

EntranceLines::EntranceLines(const StepProblem& problem, TrialContacts& trials) : trials_(trials) {
    int groups = 0;
    for (const ContactIndex k : problem.contacts.indices()) {
        const Contact& contact = problem.contacts[k];
        groups = std::max(groups, contact.group + 1);
        if (contact.group >= 0 && !contact.inhibited)
            members_.push_back({k, contact.group, contact.line, 2 * contact.inherited_penetration});
    }
    first_.resize(groups);
}

/// First entrance, Eq. (28).
bool EntranceLines::select_first() {
    std::fill(first_.begin(), first_.end(), First());
    for (const Member& member : members_) {
        First& first = first_[member.group];
        const double gap = trials_[member.contact].gap() + member.allowed;
        if (first.line < 0 || gap > first.gap) first = {member.line, gap};
    }
    bool exchanged = false;
    for (const Member& member : members_) {
        const bool may_close = first_[member.group].line == member.line;
        if (std::exchange(trials_[member.contact].may_close, may_close) != may_close) exchanged = true;
    }
    return exchanged;
}

}  // namespace rockslope::dda
