#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "dda/base/indices.hpp"
#include "dda/contact/owner_index.hpp"

namespace rockslope::dda {

/// Candidates for contacts whose corner is near an end of their edge, by the two corners that meet.
/// @tparam Candidate has `pair`, a CornerEdge, and `partner_corner`, that end.
template <class Candidate>
class CornerMeetings {
  public:
    /// @param count number of candidates for which memory is taken.
    explicit CornerMeetings(std::size_t count) {
        lower_.reserve(count);
        members_.reserve(count);
    }
    /// Adds a candidate, which must outlive this object.
    void add(const Candidate& candidate) {
        const auto [lower, upper] = std::minmax(candidate.pair.corner, candidate.partner_corner);
        lower_.push_back(lower);
        members_.push_back({upper, &candidate});
    }

    /// Sorts the candidates by their pairs of corners: pairs ascending, candidates as they were added.
    void sort(std::size_t corner_count) {
        const OwnerIndex<CornerIndex, std::uint32_t> by_lower(corner_count, lower_);
        std::vector<std::uint32_t> order;
        sorted_.reserve(members_.size());
        first_.reserve(members_.size() + 1);
        for (const CornerIndex corner : indices<CornerIndex>(0, corner_count)) {
            const auto items = by_lower.of(corner);
            order.assign(items.begin(), items.end());
            std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
                return std::pair(members_[a].first, a) < std::pair(members_[b].first, b);
            });
            CornerIndex upper = CornerIndex::none();
            for (const std::uint32_t item : order) {
                if (members_[item].first != upper) first_.push_back(sorted_.size());
                upper = members_[item].first;
                sorted_.push_back(members_[item].second);
            }
        }
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
    std::vector<CornerIndex> lower_;
    std::vector<std::pair<CornerIndex, const Candidate*>> members_;  ///< upper corner, candidate
    std::vector<const Candidate*> sorted_;
    std::vector<std::size_t> first_;  ///< per pair of corners: its first candidate in sorted_; then the end
};

}  // namespace rockslope::dda
