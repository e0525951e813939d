#include "dda/contact/shared_history.hpp"

#include <atomic>
#include <vector>

namespace dda {

struct SharedHistory::Kept {
    Room* room = nullptr;  ///< null for those that are always there
    JointHistory history;
};

struct SharedHistory::Room {
    std::atomic<int> users{1};
    std::vector<Kept> kept;  ///< never more than it was reserved for: their places stay

    explicit Room(std::size_t room) { kept.reserve(room); }
    const Kept* add(const JointHistory& history) {
        users.fetch_add(1, std::memory_order_relaxed);
        return &kept.emplace_back(Kept{this, history});
    }
    void leave() {
        if (users.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
    }
};

SharedHistory::Row::Row(std::size_t room) : room_(new Room(room)) {}

SharedHistory::Row::~Row() {
    room_->leave();
}

SharedHistory SharedHistory::Row::add(const JointHistory& history) {
    if (const Kept* there = always(history)) return SharedHistory(there);
    return room_->kept.size() < room_->kept.capacity() ? SharedHistory(room_->add(history))
                                                       : SharedHistory(history);
}

/// Nearly all smooth joints have one of these.
const SharedHistory::Kept* SharedHistory::always(const JointHistory& history) {
    static const Kept intact{nullptr, MohrCoulomb::History{false}};
    static const Kept broken{nullptr, MohrCoulomb::History{true}};
    const auto* smooth = std::get_if<MohrCoulomb::History>(&history);
    if (smooth == nullptr) return nullptr;
    return smooth->broken ? &broken : &intact;
}

SharedHistory::SharedHistory() : kept_(always(JointHistory{})) {}

SharedHistory::SharedHistory(const JointHistory& history) : kept_(always(history)) {
    if (kept_ == nullptr) *this = Row(1).add(history);
}

SharedHistory::SharedHistory(const SharedHistory& other) noexcept : kept_(other.kept_) {
    if (kept_->room != nullptr) kept_->room->users.fetch_add(1, std::memory_order_relaxed);
}

SharedHistory::~SharedHistory() {
    if (kept_ != nullptr && kept_->room != nullptr) kept_->room->leave();
}

const JointHistory& SharedHistory::operator*() const {
    return kept_->history;
}

}  // namespace dda
