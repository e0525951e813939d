#pragma once

#include <cstddef>
#include <utility>

#include "dda/joint/joint_law.hpp"

namespace dda {

/// What a joint has been through, as a contact keeps it: a value that never changes, shared by those that
/// have been through the same, as both ends of a pair of faces and the states before and after a step in
/// which nothing moved. A copy costs a count instead of the history's bytes.
class SharedHistory {
    struct Kept;
    struct Room;

  public:
    /// Makes histories that lie in memory one after the other, in the order in which they are read again. The
    /// bytes of all of them stay until nobody has any.
    class Row {
      public:
        /// @param room for how many.
        explicit Row(std::size_t room);
        Row(const Row&) = delete;
        Row& operator=(const Row&) = delete;
        ~Row();
        /// One more than there is room for lies elsewhere.
        SharedHistory add(const JointHistory& history);

      private:
        Room* room_;
    };

    SharedHistory();
    SharedHistory(const JointHistory& history);  // NOLINT(google-explicit-constructor): it is the same value
    SharedHistory(const SharedHistory& other) noexcept;
    SharedHistory(SharedHistory&& other) noexcept : kept_(std::exchange(other.kept_, nullptr)) {}
    SharedHistory& operator=(SharedHistory other) noexcept {
        std::swap(kept_, other.kept_);
        return *this;
    }
    ~SharedHistory();

    const JointHistory& operator*() const;
    operator const JointHistory&() const { return **this; }  // NOLINT(google-explicit-constructor): likewise
    friend bool operator==(const SharedHistory& a, const SharedHistory& b) {
        return a.kept_ == b.kept_ || *a == *b;
    }

  private:
    explicit SharedHistory(const Kept* kept) : kept_(kept) {}
    /// The one of those that are always there, and are not counted, that is the history; null if none is.
    static const Kept* always(const JointHistory& history);

    const Kept* kept_;  ///< null once moved from
};

}  // namespace dda
