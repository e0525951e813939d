#include "dda/path/patches.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rockslope::dda {

namespace {

/// Unbalanced blocks of a patch, and rings of neighbours around them.
constexpr std::size_t core_size = 10;
constexpr int rings = 2;
/// Blocks of a wide patch: no ring is added to so many, nor to one that grows. Rough joints of 992 blocks
/// take a fifth less time than with 250.
constexpr std::size_t wide_size = 120;

}  // namespace

Relaxation Patches::relax(const LimitedStep& step, const PatchAims& aims, RowSpan<Vec6> displacement,
                          const ThreadPool& pool) {
    step_ = &step;
    is_wide_ = aims.extent != PatchExtent::two_rings;
    paths_.resize(pool.size());
    grown_.clear();
    in_patch_.assign(displacement.size(), 0);
    is_claimed_.assign(displacement.size(), 0);
    forces_.evaluate(step, displacement, aims.length, pool);
    find_links(pool);
    Relaxation taken;
    taken.unbalanced = find_unbalanced(aims);
    while (taken.visits < aims.path.visit_limit && fill_round(aims.extent)) {
        balance_round(aims.path, aims.path.visit_limit - taken.visits, displacement, pool);
        for (Patch& patch : round_) {
            taken.visits += patch.outcome.visits;
            taken.borders += patch.outcome.borders;
            if (!patch.has_grown) ++taken.patches;
            if (!patch.outcome.balanced) ++taken.failed;
            if (grow(patch, aims)) grown_.push_back(std::move(patch));
        }
    }
    return taken;
}

void Patches::find_links(const ThreadPool& pool) {
    links_.resize(step_->contacts.size());
    pool.parallel_for(links_.size(), [&](std::size_t begin, std::size_t end) {
        for (const ContactIndex k : indices<ContactIndex>(begin, end)) {
            const LimitedContact& contact = step_->contacts[k];
            links_[k] = contact.may_close
                            ? Link{contact.rows->first, contact.rows->second, contact.least_normal}
                            : Link{};
        }
    });
}

bool Patches::fill_round(PatchExtent extent) {
    round_.clear();
    for (Patch& patch : std::exchange(grown_, {}))
        if (!add_to_round(patch)) grown_.push_back(std::move(patch));
    for (const RowIndex row : is_unbalanced_.indices()) {
        if (is_unbalanced_[row] == 0 || is_claimed_[row] != 0) continue;
        Patch patch = patch_around(row, extent);
        if (!add_to_round(patch)) put_back(patch);
    }
    return !round_.empty();
}

bool Patches::add_to_round(Patch& patch) {
    if (meets_round(patch.rows)) return false;
    for (const RowIndex row : patch.rows) {
        is_claimed_[row] = 1;
        for (const ContactIndex k : step_->row_contacts.of(row)) {
            for (const RowIndex each : {links_[k].first, links_[k].second})
                if (each.exists()) is_claimed_[each] = 1;
        }
    }
    round_.push_back(std::move(patch));
    return true;
}

bool Patches::meets_round(std::span<const RowIndex> rows) const {
    return std::any_of(rows.begin(), rows.end(), [&](RowIndex row) { return is_claimed_[row] != 0; });
}

void Patches::balance_round(const PathAims& aims, double visit_limit, RowSpan<Vec6> displacement,
                            const ThreadPool& pool) {
    PathAims path = aims;
    path.visit_limit = visit_limit;
    pool.parallel_for_dynamic(round_.size(), [&](std::size_t k, std::size_t thread) {
        round_[k].outcome =
            paths_[thread].follow(*step_, round_[k].rows, {displacement, forces_.elastic()}, path);
    });
    is_claimed_.assign(is_claimed_.size(), 0);
}

bool Patches::grow(Patch& patch, const PatchAims& aims) {
    const double most_thrown = std::max(aims.most_thrown * patch.core_force, aims.tolerance);
    if (!patch.outcome.balanced || patch.outcome.thrown <= most_thrown) return false;
    const std::size_t blocks = patch.rows.size();
    for (const RowIndex row : patch.rows) in_patch_[row] = 1;
    add_rings(rings, wide_size, patch.rows);
    patch.has_grown = true;
    for (const RowIndex row : patch.rows) in_patch_[row] = 0;
    return patch.rows.size() > blocks;
}

double Patches::find_unbalanced(const PatchAims& aims) {
    largest_.resize(in_patch_.size());
    is_unbalanced_.resize(in_patch_.size());
    double largest = 0;
    for (const RowIndex row : largest_.indices()) {
        largest_[row] = forces_.unbalanced(row).cwiseAbs().maxCoeff();
        largest = std::max(largest, largest_[row]);
    }
    const double least = std::max(aims.tolerance, aims.share * largest);
    for (const RowIndex row : largest_.indices()) is_unbalanced_[row] = largest_[row] > least ? 1 : 0;
    return largest;
}

template <class Visit>
void Patches::for_neighbours(RowIndex row, const Visit& visit) const {
    for (const ContactIndex k : step_->row_contacts.of(row)) {
        const Link& link = links_[k];
        if (!is_wide_ && !(forces_.elastic()[k].normal > link.least_normal)) continue;
        const RowIndex other = link.first == row ? link.second : link.first;
        if (other.exists()) visit(other);
    }
}

Patches::Patch Patches::patch_around(RowIndex row, PatchExtent extent) {
    Patch patch;
    switch (extent) {
        case PatchExtent::two_rings:
            patch = core_around(row, core_size);
            add_rings(rings, std::numeric_limits<std::size_t>::max(), patch.rows);
            break;
        case PatchExtent::wide:
            patch = core_around(row, wide_size);
            add_rings(static_cast<int>(wide_size), wide_size, patch.rows);
            break;
        case PatchExtent::all_blocks:
            for (const RowIndex each : in_patch_.indices()) add_to_core(each, patch);
            break;
    }
    for (const RowIndex each : patch.rows) in_patch_[each] = 0;
    return patch;
}

Patches::Patch Patches::core_around(RowIndex row, std::size_t size) {
    Patch core;
    add_to_core(row, core);
    for (std::size_t next = 0; next < core.rows.size(); ++next) {
        for_neighbours(core.rows[next], [&](RowIndex other) {
            if (is_unbalanced_[other] != 0 && core.rows.size() < size) add_to_core(other, core);
        });
    }
    return core;
}

void Patches::add_to_core(RowIndex row, Patch& patch) {
    patch.core_force = std::max(patch.core_force, largest_[row]);
    ++patch.core_size;
    patch.rows.push_back(row);
    is_unbalanced_[row] = 0;
    in_patch_[row] = 1;
}

void Patches::put_back(const Patch& patch) {
    for (std::size_t k = 0; k < patch.core_size; ++k) is_unbalanced_[patch.rows[k]] = 1;
}

void Patches::add_rings(int count, std::size_t size, std::vector<RowIndex>& rows) {
    for (int ring = 0; ring < count && rows.size() < size && !meets_round(rows); ++ring) {
        const std::size_t before = rows.size();
        add_ring(rows);
        if (rows.size() == before) break;
    }
}

void Patches::add_ring(std::vector<RowIndex>& rows) {
    const std::size_t inside = rows.size();
    for (std::size_t k = 0; k < inside; ++k) {
        for_neighbours(rows[k], [&](RowIndex other) {
            if (in_patch_[other] != 0) return;
            in_patch_[other] = 1;
            rows.push_back(other);
        });
    }
}

}  // namespace rockslope::dda
