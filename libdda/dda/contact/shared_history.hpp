#pragma once

#include <cstddef>
#include <utility>

#include "dda/joint/joint_law.hpp"

namespace rockslope::dda {

/// What a joint has been through, as a contact keeps it: a value that never changes, shared by those that
/// have been through the same, as both ends of a pair of faces and the states before and after a step in
/// which nothing moved. A copy costs a count instead of the history's bytes.
class SharedHistory {
    struct Node;
    struct Pool;

  public:
    /// Makes histories that lie in memory one after the other, in the order in which they are read again. The
    /// bytes of all of them stay until nobody has any.
    class Batch {
      public:
        /// @param room for how many.
        explicit Batch(std::size_t room);
        Batch(const Batch&) = delete;
        Batch& operator=(const Batch&) = delete;
        ~Batch();
        /// One more than there is room for lies elsewhere.
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
    operator const JointHistory&() const { return **this; }  // NOLINT(google-explicit-constructor): likewise
    friend bool operator==(const SharedHistory& a, const SharedHistory& b) {
        return a.node_ == b.node_ || *a == *b;
    }

  private:
    explicit SharedHistory(const Node* kept) : node_(kept) {}
    /// The one of those that are always there, and are not counted, that is the history; null if none is.
    static const Node* static_node(const JointHistory& history);

    const Node* node_;  ///< null once moved from
};

}  // namespace rockslope::dda
