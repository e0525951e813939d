#include "dda/contact/shared_history.hpp"

#include <array>
#include <atomic>
#include <type_traits>
#include <variant>
#include <vector>

namespace rockslope::dda {

struct SharedHistory::Node {
    Pool* pool = nullptr;  ///< null for a static node
    JointHistory history;

    /// The static node with this history, or null: one of the common histories of its law.
    template <class... Laws>
    static const Node* find_common(std::type_identity<std::variant<Laws...>>, const JointHistory& history) {
        const Node* found = nullptr;
        const auto is_own = [&]<class Law>(std::type_identity<Law>) {
            const auto* own = std::get_if<typename Law::History>(&history);
            if (own != nullptr) found = find_common_of<Law>(*own);
            return own != nullptr;
        };
        (is_own(std::type_identity<Laws>{}) || ...);
        return found;
    }
    template <class Law>
    static const Node* find_common_of(const typename Law::History& history) {
        static constexpr auto common = Law::common_histories();
        static const auto nodes = [] {
            std::array<Node, common.size()> made;
            for (std::size_t k = 0; k < common.size(); ++k) made[k].history = common[k];
            return made;
        }();
        for (std::size_t k = 0; k < common.size(); ++k)
            if (common[k] == history) return &nodes[k];
        return nullptr;
    }
};

struct SharedHistory::Pool {
    std::atomic<int> reference_count{1};
    std::vector<Node> nodes;  ///< no more than its capacity, so no node ever moves

    explicit Pool(std::size_t capacity) { nodes.reserve(capacity); }
    const Node* add(const JointHistory& history) {
        reference_count.fetch_add(1, std::memory_order_relaxed);
        return &nodes.emplace_back(Node{this, history});
    }
    void release() {
        if (reference_count.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
    }
};

SharedHistory::Batch::Batch(std::size_t capacity) : pool_(new Pool(capacity)) {}

SharedHistory::Batch::~Batch() {
    pool_->release();
}

SharedHistory SharedHistory::Batch::add(const JointHistory& history) {
    if (const Node* common = static_node(history)) return SharedHistory(common);
    return pool_->nodes.size() < pool_->nodes.capacity() ? SharedHistory(pool_->add(history))
                                                         : SharedHistory(history);
}

const SharedHistory::Node* SharedHistory::static_node(const JointHistory& history) {
    return Node::find_common(std::type_identity<JointLaw>{}, history);
}

SharedHistory::SharedHistory() : node_(static_node(JointHistory{})) {}

SharedHistory::SharedHistory(const JointHistory& history) : node_(static_node(history)) {
    if (node_ == nullptr) *this = Batch(1).add(history);
}

SharedHistory::SharedHistory(const SharedHistory& other) noexcept : node_(other.node_) {
    if (node_->pool != nullptr) node_->pool->reference_count.fetch_add(1, std::memory_order_relaxed);
}

SharedHistory::~SharedHistory() {
    if (node_ != nullptr && node_->pool != nullptr) node_->pool->release();
}

const JointHistory& SharedHistory::operator*() const {
    return node_->history;
}

}  // namespace rockslope::dda
