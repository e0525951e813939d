#include "dda/contact/shared_history.hpp"

#include <atomic>

namespace dda {

struct SharedHistory::Kept {
    JointHistory history;
    bool always = false;
    mutable std::atomic<int> users{1};
};

/// Nearly all smooth joints have one of these.
const SharedHistory::Kept* SharedHistory::always(const JointHistory& history) {
    static const Kept intact{MohrCoulomb::History{false}, true};
    static const Kept broken{MohrCoulomb::History{true}, true};
    const auto* smooth = std::get_if<MohrCoulomb::History>(&history);
    if (smooth == nullptr) return nullptr;
    return smooth->broken ? &broken : &intact;
}

SharedHistory::SharedHistory() : kept_(always(JointHistory{})) {}

SharedHistory::SharedHistory(const JointHistory& history) : kept_(always(history)) {
    if (kept_ == nullptr) kept_ = new Kept{history};
}

SharedHistory::SharedHistory(const SharedHistory& other) noexcept : kept_(other.kept_) {
    if (!kept_->always) kept_->users.fetch_add(1, std::memory_order_relaxed);
}

SharedHistory::~SharedHistory() {
    if (kept_ == nullptr || kept_->always) return;
    if (kept_->users.fetch_sub(1, std::memory_order_acq_rel) == 1) delete kept_;
}

const JointHistory& SharedHistory::operator*() const {
    return kept_->history;
}

}  // namespace dda
