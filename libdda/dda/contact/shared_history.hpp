#pragma once

#include <cstddef>
#include <utility>

#include "dda/joint/joint_law.hpp"

namespace rockslope::dda {

/// The history of a joint in a contact: an immutable, reference-counted value. Contacts of one joint segment
/// share it, and so do the states before and after a step in which the joint did not move. A copy increments
/// a counter instead of copying the history. The common histories of a law exist once and are not counted.
class SharedHistory {
    struct Node;
    struct Pool;

  public:
    /// Allocates histories side by side in memory, in the order in which they are read. Their memory is
    /// released when the last of them is.
    class Batch {
      public:
        /// @param capacity number of histories.
        explicit Batch(std::size_t capacity);
        Batch(const Batch&) = delete;
        Batch& operator=(const Batch&) = delete;
        ~Batch();
        /// Beyond the capacity a history gets memory of its own.
        SharedHistory add(const JointHistory& history);

      private:
        Pool* pool_;
    };

    SharedHistory();
    SharedHistory(const JointHistory& history);  // NOLINT(google-explicit-constructor): it is the same value
    SharedHistory(const SharedHistory& other) noexcept;
    SharedHistory(SharedHistory&& other) noexcept : node_(std::exchange(other.node_, nullptr)) {}
    SharedHistory& operator=(SharedHistory other) noexcept {
        std::swap(node_, other.node_);
        return *this;
    }
    ~SharedHistory();

    const JointHistory& operator*() const;
    operator const JointHistory&() const { return **this; }  // NOLINT(google-explicit-constructor): as above
    friend bool operator==(const SharedHistory& a, const SharedHistory& b) {
        return a.node_ == b.node_ || *a == *b;
    }

  private:
    explicit SharedHistory(const Node* node) : node_(node) {}
    /// The static, uncounted node with this history, or null.
    static const Node* static_node(const JointHistory& history);

    const Node* node_;  ///< null once moved from
};

}  // namespace rockslope::dda
