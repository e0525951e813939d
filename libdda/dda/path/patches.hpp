#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/path/patch_path.hpp"

namespace rockslope::dda {

/// The blocks of a patch: those out of balance with two rings of neighbours, hundreds of blocks, or all.
enum class PatchExtent : std::uint8_t { two_rings, wide, all_blocks };

/// How far a relaxation goes.
struct PatchAims {
    double tolerance = 0;          ///< N per metre; unbalanced forces below it are left
    double share = 0;              ///< those below this share of the largest are left as well
    RowSpan<const double> length;  ///< m, per row: moments over it are compared with forces
    PatchExtent extent = PatchExtent::two_rings;
    PathAims path;  ///< its visits are those of all patches; no round begins when they are used up
    /// A patch that throws more force on a block around it than so many times the largest unbalanced one of
    /// its core grows.
    double most_thrown = std::numeric_limits<double>::infinity();
};

/// What a relaxation took.
struct Relaxation {
    int patches = 0;
    int failed = 0;         ///< patches whose path did not end, left as they were
    int borders = 0;        ///< crossed on paths: a pivot each
    double visits = 0;      ///< contacts that the search for borders looked at
    double unbalanced = 0;  ///< N per metre, the largest unbalanced force before
};

/// Balances the blocks whose forces do not balance, in small patches that overlap, by PatchPath; everything
/// outside a patch stays meanwhile. A patch is ten such blocks at most that hang together, and two rings of
/// neighbours around them. A wide one has as many rings as 120 blocks fill, also over contacts that are open
/// and may close. Where loose blocks balance only after a long way, they press on those around the patch more
/// than they were out of balance; such a patch grows by two rings and is balanced again, up to the size of a
/// wide one. The far field is left to the linear system of all blocks. A patch of all blocks has none: its
/// path is the exact one of the step.
///
/// Patches are balanced in rounds. Those of a round have no contact in common, so threads share them, and the
/// blocks end in the same bytes with any number of threads. Memory is kept from step to step.
class Patches {
  public:
    /// @param displacement per row, m; changed in the patches. @return the patches, and what they took.
    Relaxation relax(const LimitedStep& step, const PatchAims& aims, RowSpan<Vec6> displacement,
                     const ThreadPool& pool);

  private:
    /// Blocks that are balanced together.
    struct Patch {
        std::vector<RowIndex> rows;  ///< its core first
        std::size_t core_size = 0;
        double core_force = 0;  ///< the largest unbalanced force of its core, N per metre
        bool has_grown = false;
        PatchPath::Outcome outcome;  ///< of its last path
    };

    /// The rows of a contact that may close, in few bytes: choosing patches visits contacts in any order.
    struct Link {
        RowIndex first = RowIndex::none();
        RowIndex second = RowIndex::none();
        double least_normal = 0;  ///< N per metre, see LimitedContact
    };

    /// Finds the links of all contacts.
    void find_links(const ThreadPool& pool);
    /// Marks the blocks whose unbalanced force is over the aims. @return the largest unbalanced force, N per
    /// metre.
    double find_unbalanced(const PatchAims& aims);
    /// Fills a round: patches that have grown, and then those around unbalanced blocks in their order, where
    /// no patch of the round is near. The others stay for a later round. @return whether there is any.
    bool fill_round(PatchExtent extent);
    /// Adds a patch to the round, unless it meets it. @return whether it was added.
    bool add_to_round(Patch& patch);
    /// Whether blocks would have a contact in common with a patch of the round.
    bool meets_round(std::span<const RowIndex> rows) const;
    /// Balances the patches of the round. @param visit_limit contacts that the search for borders may look at
    /// in each.
    void balance_round(const PathAims& aims, double visit_limit, RowSpan<Vec6> displacement,
                       const ThreadPool& pool);
    /// Lets a patch grow if it throws too much force on the blocks around it. @return whether it grew.
    bool grow(Patch& patch, const PatchAims& aims);

    /// The patch around an unbalanced block, or as much of it as already meets the round.
    Patch patch_around(RowIndex row, PatchExtent extent);
    /// A patch of unbalanced blocks that hang together, from one of them on; they are no longer marked.
    /// @param size most blocks.
    Patch core_around(RowIndex row, std::size_t size);
    void add_to_core(RowIndex row, Patch& patch);
    /// Marks the blocks of a core as unbalanced again.
    void put_back(const Patch& patch);
    /// Adds rings of neighbours to the patch while it is smaller than the size and does not meet the round.
    void add_rings(int count, std::size_t size, std::vector<RowIndex>& rows);
    void add_ring(std::vector<RowIndex>& rows);
    /// Calls visit(row) for each block that presses on a block, or in a wide patch may, in the order of the
    /// contacts.
    template <class Visit>
    void for_neighbours(RowIndex row, const Visit& visit) const;

    const LimitedStep* step_ = nullptr;
    bool is_wide_ = false;
    std::vector<PatchPath> paths_;  ///< per thread
    std::vector<Patch> round_;
    std::vector<Patch> grown_;  ///< for the next round
    LimitedForces forces_;
    PerContact<Link> links_;
    PerRow<double> largest_;  ///< per row: of its unbalanced forces, N per metre
    PerRow<char> is_unbalanced_;
    PerRow<char> in_patch_;    ///< while a patch is formed
    PerRow<char> is_claimed_;  ///< in a patch of the round, or in contact with one
};

}  // namespace rockslope::dda
