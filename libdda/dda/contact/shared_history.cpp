#include "dda/contact/shared_history.hpp"

#include <atomic>
#include <vector>

namespace rockslope::dda {

struct SharedHistory::Node {
    Pool* room = nullptr;  ///< null for those that are always there
    JointHistory history;
};

struct SharedHistory::Pool {
    std::atomic<int> reference_count{1};
    std::vector<Node> nodes;  ///< never more than it was reserved for: their places stay

    explicit Pool(std::size_t room) { nodes.reserve(room); }
    const Node* add(const JointHistory& history) {
        reference_count.fetch_add(1, std::memory_order_relaxed);
        return &nodes.emplace_back(Node{this, history});
    }
    void release() {
        if (reference_count.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
    }
};

SharedHistory::Batch::Batch(std::size_t room) : pool_(new Pool(room)) {}

SharedHistory::Batch::~Batch() {
    pool_->release();
}

SharedHistory SharedHistory::Batch::add(const JointHistory& history) {
    if (const Node* there = static_node(history)) return SharedHistory(there);
    return pool_->nodes.size() < pool_->nodes.capacity() ? SharedHistory(pool_->add(history))
                                                         : SharedHistory(history);
}

/// Nearly all smooth joints have one of these.
const SharedHistory::Node* SharedHistory::static_node(const JointHistory& history) {
    static const Node intact{nullptr, MohrCoulomb::History{false}};
    static const Node broken{nullptr, MohrCoulomb::History{true}};
    const auto* smooth = std::get_if<MohrCoulomb::History>(&history);
    if (smooth == nullptr) return nullptr;
    return smooth->broken ? &broken : &intact;
}

SharedHistory::SharedHistory() : node_(static_node(JointHistory{})) {}

SharedHistory::SharedHistory(const JointHistory& history) : node_(static_node(history)) {
    if (node_ == nullptr) *this = Batch(1).add(history);
}

SharedHistory::SharedHistory(const SharedHistory& other) noexcept : node_(other.node_) {
    if (node_->room != nullptr) node_->room->reference_count.fetch_add(1, std::memory_order_relaxed);
}

SharedHistory::~SharedHistory() {
    if (node_ != nullptr && node_->room != nullptr) node_->room->release();
}

const JointHistory& SharedHistory::operator*() const {
    return node_->history;
}

}  // namespace rockslope::dda
