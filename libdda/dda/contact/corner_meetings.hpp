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

    /// Calls `visit` with the candidates of each pair of corners: pairs ascending, candidates as they were
    /// added.
    template <class Visit>
    void for_each(std::size_t corner_count, const Visit& visit) const {
        const OwnerIndex<CornerIndex, std::uint32_t> by_lower(corner_count, lower_);
        std::vector<std::uint32_t> order;
        std::vector<const Candidate*> together;
        for (const CornerIndex corner : indices<CornerIndex>(0, corner_count)) {
            const auto items = by_lower.of(corner);
            order.assign(items.begin(), items.end());
            std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
                return std::pair(members_[a].first, a) < std::pair(members_[b].first, b);
            });
            for (auto item = order.begin(); item != order.end();) {
                const CornerIndex upper = members_[*item].first;
                together.clear();
                for (; item != order.end() && members_[*item].first == upper; ++item)
                    together.push_back(members_[*item].second);
                visit(std::span<const Candidate* const>(together));
            }
        }
    }

  private:
    std::vector<CornerIndex> lower_;
    std::vector<std::pair<CornerIndex, const Candidate*>> members_;  ///< upper corner, candidate
};

}  // namespace rockslope::dda
