#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <iterator>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace rockslope {

/// The index of one kind of thing: of a block, a corner, a row. Plain integers convert into every kind, but
/// no kind converts into another one: a row where a block is expected does not compile. An index subscripts
/// standard containers as it is, and of the containers below only those of its own kind. @tparam Kind a
/// name, never defined.
template <class Kind>
class Index {
  public:
    constexpr Index() = default;
    template <std::integral Integer>
    constexpr Index(Integer value)  // NOLINT(google-explicit-constructor): an integer is an index of any kind
        : value_(static_cast<std::int32_t>(value)) {}

    /// The index of nothing, -1.
    static constexpr Index none() { return -1; }
    /// Whether this is the index of a thing; none() is not.
    constexpr bool exists() const { return value_ >= 0; }

    /// The number of the thing.
    constexpr std::int32_t value() const { return value_; }
    /// The subscript. A template converts into this type only: not into any number, nor on into another kind.
    template <std::same_as<std::size_t> Subscript>
    constexpr operator Subscript() const {  // NOLINT(google-explicit-constructor): see above
        return static_cast<Subscript>(value_);
    }

    constexpr Index& operator++() {
        ++value_;
        return *this;
    }
    constexpr Index operator++(int) {
        const Index before = *this;
        ++value_;
        return before;
    }
    template <std::integral Integer>
    friend constexpr Index operator+(Index index, Integer steps) {
        return index.value_ + static_cast<std::int32_t>(steps);
    }
    template <std::integral Integer>
    friend constexpr Index operator-(Index index, Integer steps) {
        return index.value_ - static_cast<std::int32_t>(steps);
    }
    friend constexpr std::int32_t operator-(Index a, Index b) { return a.value_ - b.value_; }

    friend constexpr bool operator==(Index, Index) = default;
    friend constexpr auto operator<=>(Index, Index) = default;
    template <std::integral Integer>
    friend constexpr bool operator==(Index index, Integer value) {
        return index.value_ == static_cast<std::int64_t>(value);
    }
    template <std::integral Integer>
    friend constexpr auto operator<=>(Index index, Integer value) {
        return std::int64_t{index.value_} <=> static_cast<std::int64_t>(value);
    }
    template <class Traits>
    friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out, Index index) {
        return out << index.value_;
    }

  private:
    std::int32_t value_ = 0;
};

template <class Other, class Key>
concept DifferentFrom = !std::same_as<Other, Key>;

template <class Kind, DifferentFrom<Kind> Other>
bool operator==(Index<Kind>, Index<Other>) = delete;
template <class Kind, DifferentFrom<Kind> Other>
std::strong_ordering operator<=>(Index<Kind>, Index<Other>) = delete;

/// The indices from one up to another, for a loop.
template <class Key>
class IndexRange {
  public:
    class Iterator {
      public:
        using value_type = Key;
        using difference_type = std::ptrdiff_t;
        using pointer = const Key*;
        using reference = Key;
        using iterator_category = std::input_iterator_tag;

        constexpr Iterator() = default;
        constexpr explicit Iterator(Key key) : key_(key) {}
        constexpr Key operator*() const { return key_; }
        constexpr Iterator& operator++() {
            ++key_;
            return *this;
        }
        constexpr Iterator operator++(int) { return Iterator(key_++); }
        friend constexpr bool operator==(Iterator, Iterator) = default;

      private:
        Key key_;
    };

    /// @param end after the last; no less than `begin`.
    constexpr IndexRange(Key begin, Key end) : begin_(begin), end_(end) {}
    constexpr Iterator begin() const { return Iterator(begin_); }
    constexpr Iterator end() const { return Iterator(end_); }
    /// Number of indices.
    constexpr std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }

  private:
    Key begin_, end_;
};

/// [0, count).
template <class Key>
constexpr IndexRange<Key> indices(Key count) {
    return {0, count};
}
/// [begin, end).
template <class Key>
constexpr IndexRange<Key> indices(Key begin, Key end) {
    return {begin, end};
}

/// A vector with one element for each thing of a kind. Only the kind's index subscripts it.
template <class Key, class T>
class IndexedVector : public std::vector<T> {
  public:
    using std::vector<T>::vector;
    IndexedVector() = default;
    IndexedVector(std::vector<T> values)  // NOLINT(google-explicit-constructor): the elements say no kind
        : std::vector<T>(std::move(values)) {}
    template <DifferentFrom<Key> Other>
    IndexedVector(const IndexedVector<Other, T>&) = delete;

    T& operator[](Key key) { return std::vector<T>::operator[](key); }
    const T& operator[](Key key) const { return std::vector<T>::operator[](key); }
    /// All indices.
    IndexRange<Key> indices() const { return {0, this->size()}; }
};

template <class Key, class T>
class IndexedSpan;

/// Whether a container is one of indices of another kind.
template <class Key, class Container>
inline constexpr bool is_of_other_kind = false;
template <class Key, class Other, class T>
inline constexpr bool is_of_other_kind<Key, IndexedVector<Other, T>> = !std::same_as<Key, Other>;
template <class Key, class Other, class T>
inline constexpr bool is_of_other_kind<Key, IndexedSpan<Other, T>> = !std::same_as<Key, Other>;

/// A contiguous range that an IndexedSpan can be a view of.
template <class Range, class Key, class T>
concept ViewableBy =
    std::constructible_from<std::span<T>, Range> && !is_of_other_kind<Key, std::remove_cvref_t<Range>>;

/// A view of what an IndexedVector holds, or of any contiguous range that says no kind.
template <class Key, class T>
class IndexedSpan : public std::span<T> {
  public:
    constexpr IndexedSpan() = default;
    template <ViewableBy<Key, T> Range>
    // A span of its own kind taken by this constructor is the copy that the others would make.
    constexpr IndexedSpan(Range&& range)  // NOLINT(bugprone-forwarding-reference-overload)
        : std::span<T>(std::forward<Range>(range)) {}

    constexpr T& operator[](Key key) const { return std::span<T>::operator[](key); }
    /// All indices.
    constexpr IndexRange<Key> indices() const { return {0, this->size()}; }
};

}  // namespace rockslope
