#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "common/base/parallel_parts.hpp"
#include "dda/base/indices.hpp"
#include "dda/contact/owner_index.hpp"

namespace rockslope::dda {

/// Candidates for contacts whose corner is near an end of their edge, by the two corners that meet.
/// @tparam Candidate has `pair`, a CornerEdge, and `partner_corner`, that end.
template <class Candidate>
class CornerMeetings {
  public:
    /// Takes memory for as many candidates.
    void reserve(std::size_t count) {
        lower_.reserve(count);
        members_.reserve(count);
    }
    /// Adds a candidate, which must outlive this object.
    void add(const Candidate& candidate) {
        const auto [lower, upper] = std::minmax(candidate.pair.corner, candidate.partner_corner);
        lower_.push_back(lower);
        members_.push_back({upper, &candidate});
    }
    /// Adds the candidates of another collection.
    void add(const CornerMeetings& more) {
        append(lower_, more.lower_);
        append(members_, more.members_);
    }

    /// Sorts the candidates by their pairs of corners: pairs ascending, candidates as they were added.
    void sort(std::size_t corner_count, const ThreadPool& pool) {
        const OwnerIndex<CornerIndex, std::uint32_t> by_lower(corner_count, lower_);
        sorted_.resize(members_.size());
        const auto firsts = parallel_parts(pool, corner_count, [&](std::size_t begin, std::size_t end) {
            return sort_from(by_lower, begin, end);
        });
        first_.reserve(members_.size() + 1);
        for (const std::vector<std::size_t>& part : firsts) append(first_, part);
        first_.push_back(sorted_.size());
    }

    /// Number of candidates.
    std::size_t size() const { return members_.size(); }
    /// Number of pairs of corners that meet, once they are sorted.
    std::size_t count() const { return first_.size() - 1; }
    /// Number of candidates of all pairs before this one.
    std::size_t first(std::size_t meeting) const { return first_[meeting]; }
    /// The candidates of a pair of corners.
    std::span<const Candidate* const> of(std::size_t meeting) const {
        return std::span(sorted_).subspan(first_[meeting], first_[meeting + 1] - first_[meeting]);
    }

  private:
    /// Sorts the candidates whose lower corner is in [begin, end). @return the first of each pair of corners.
    std::vector<std::size_t> sort_from(const OwnerIndex<CornerIndex, std::uint32_t>& by_lower,
                                       std::size_t begin, std::size_t end) {
        std::vector<std::size_t> first;
        first.reserve(by_lower.offset(CornerIndex(end)) - by_lower.offset(CornerIndex(begin)));
        std::vector<std::uint32_t> order;
        for (const CornerIndex corner : indices<CornerIndex>(begin, end)) {
            const auto items = by_lower.of(corner);
            order.assign(items.begin(), items.end());
            std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
                return std::pair(members_[a].first, a) < std::pair(members_[b].first, b);
            });
            std::size_t at = by_lower.offset(corner);
            CornerIndex upper = CornerIndex::none();
            for (const std::uint32_t item : order) {
                if (members_[item].first != upper) first.push_back(at);
                upper = members_[item].first;
                sorted_[at++] = members_[item].second;
            }
        }
        return first;
    }

    std::vector<CornerIndex> lower_;
    std::vector<std::pair<CornerIndex, const Candidate*>> members_;  ///< upper corner, candidate
    std::vector<const Candidate*> sorted_;
    std::vector<std::size_t> first_;  ///< per pair of corners: its first candidate in sorted_; then the end
};

}  // namespace rockslope::dda
