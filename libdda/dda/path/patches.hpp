#pragma once

#include <cstdint>
#include <limits>
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
    PathAims path;  ///< its visits are those of all patches
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

/// Balances the blocks whose forces do not balance, in small patches that overlap, one after the other by
/// PatchPath; everything outside a patch stays meanwhile. A patch is ten such blocks at most that hang
/// together, and two rings of neighbours around them. A wide one has as many rings as 250 blocks fill, also
/// over contacts that are open and may close. Where loose blocks balance only after a long way, they press on
/// those around the patch more than they were out of balance; such a patch grows by two rings and is balanced
/// again, up to the size of a wide one. The far field is left to the linear system of all blocks. A patch of
/// all blocks has none: its path is the exact one of the step. Memory is kept from step to step.
class Patches {
  public:
    /// @param displacement per row, m; changed in the patches. @return the patches, and what they took.
    Relaxation relax(const LimitedStep& step, const PatchAims& aims, RowSpan<Vec6> displacement,
                     const ThreadPool& pool);

  private:
    /// Marks the blocks whose unbalanced force is over the aims. @return the largest unbalanced force, N per
    /// metre.
    double find_unbalanced(const PatchAims& aims);
    /// Sets the patch for an unbalanced block.
    void set_patch(RowIndex row, PatchExtent extent);
    void set_all_blocks();
    /// Sets the patch to unbalanced blocks that hang together, from one of them on; they are no longer
    /// marked.
    /// @param size most blocks.
    void set_core(RowIndex row, std::size_t size);
    /// Adds rings of neighbours to the patch while it is smaller than the size.
    void add_rings(int count, std::size_t size);
    void add_ring();
    /// Balances the patch, and lets it grow where it throws too much force on the blocks around it.
    /// @param visit_limit contacts that the search for borders may look at.
    PatchPath::Outcome balance(const PatchAims& aims, double visit_limit, RowSpan<Vec6> displacement);
    /// Calls visit(row) for each block that presses on a block, or in a wide patch may, in the order of the
    /// contacts.
    template <class Visit>
    void for_neighbours(RowIndex row, const Visit& visit) const;

    const LimitedStep* step_ = nullptr;
    bool is_wide_ = false;
    PatchPath path_;
    std::vector<RowIndex> patch_;
    double core_force_ = 0;  ///< the largest unbalanced force of the patch's core, N per metre
    LimitedForces forces_;
    PerRow<double> largest_;  ///< per row: of its unbalanced forces, N per metre
    PerRow<char> is_unbalanced_;
    PerRow<char> in_patch_;
};

}  // namespace rockslope::dda
