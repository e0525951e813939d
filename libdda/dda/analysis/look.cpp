#include "dda/analysis/look.hpp"

namespace dda {

std::vector<const JudgedContact*> Guess::of(std::span<const Contact> others) const {
    std::vector<const JudgedContact*> found(others.size(), nullptr);
    std::size_t k = 0;
    for (std::size_t other = 0; other < others.size(); ++other) {
        while (k < contacts.size() && comes_before(contacts[k], others[other])) ++k;
        if (k < contacts.size() && !comes_before(others[other], contacts[k])) found[other] = &judged[k];
    }
    return found;
}

}  // namespace dda
