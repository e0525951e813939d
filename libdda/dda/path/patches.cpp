#include "dda/path/patches.hpp"

#include <algorithm>
#include <limits>

namespace rockslope::dda {

namespace {

/// Unbalanced blocks of a patch, and rings of neighbours around them.
constexpr std::size_t core_size = 10;
constexpr int rings = 2;
/// Blocks of a wide patch: no ring is added to so many.
constexpr std::size_t wide_size = 250;

}  // namespace

Relaxation Patches::relax(const LimitedStep& step, const PatchAims& aims, RowSpan<Vec6> displacement,
                          const ThreadPool& pool) {
    step_ = &step;
    is_wide_ = aims.extent != PatchExtent::two_rings;
    in_patch_.assign(displacement.size(), 0);
    forces_.evaluate(step, displacement, aims.length, pool);
    Relaxation taken;
    taken.unbalanced = find_unbalanced(aims);
    for (const RowIndex row : is_unbalanced_.indices()) {
        if (is_unbalanced_[row] == 0) continue;
        if (taken.visits >= aims.path.visit_limit) break;
        set_patch(row, aims.extent);
        const PatchPath::Outcome outcome = balance(aims, aims.path.visit_limit - taken.visits, displacement);
        for (const RowIndex each : patch_) in_patch_[each] = 0;
        taken.visits += outcome.visits;
        taken.borders += outcome.borders;
        ++taken.patches;
        if (!outcome.balanced) ++taken.failed;
    }
    return taken;
}

PatchPath::Outcome Patches::balance(const PatchAims& aims, double visit_limit, RowSpan<Vec6> displacement) {
    const LimitedIterate iterate{displacement, forces_.elastic()};
    const double most_thrown = std::max(aims.most_thrown * core_force_, aims.tolerance);
    PathAims path = aims.path;
    path.visit_limit = visit_limit;
    PatchPath::Outcome outcome = path_.follow(*step_, patch_, iterate, path);
    while (outcome.balanced && outcome.thrown > most_thrown && outcome.visits < visit_limit &&
           patch_.size() < wide_size) {
        const std::size_t blocks = patch_.size();
        add_rings(rings, wide_size);
        if (patch_.size() == blocks) break;
        path.visit_limit = visit_limit - outcome.visits;
        outcome += path_.follow(*step_, patch_, iterate, path);
    }
    return outcome;
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
        const LimitedContact& contact = step_->contacts[k];
        if (!contact.may_close) continue;
        if (!is_wide_ && !(forces_.elastic()[k].normal > contact.least_normal)) continue;
        const RowIndex other = contact.rows->first == row ? contact.rows->second : contact.rows->first;
        if (other.exists()) visit(other);
    }
}

void Patches::set_patch(RowIndex row, PatchExtent extent) {
    switch (extent) {
        case PatchExtent::two_rings:
            set_core(row, core_size);
            add_rings(rings, std::numeric_limits<std::size_t>::max());
            break;
        case PatchExtent::wide:
            set_core(row, wide_size);
            add_rings(static_cast<int>(wide_size), wide_size);
            break;
        case PatchExtent::all_blocks:
            set_all_blocks();
            break;
    }
}

void Patches::set_all_blocks() {
    patch_.clear();
    core_force_ = 0;
    for (const RowIndex row : in_patch_.indices()) {
        core_force_ = std::max(core_force_, largest_[row]);
        is_unbalanced_[row] = 0;
        in_patch_[row] = 1;
        patch_.push_back(row);
    }
}

void Patches::set_core(RowIndex row, std::size_t size) {
    const auto add = [&](RowIndex block) {
        core_force_ = std::max(core_force_, largest_[block]);
        is_unbalanced_[block] = 0;
        in_patch_[block] = 1;
        patch_.push_back(block);
    };
    patch_.clear();
    core_force_ = 0;
    add(row);
    std::size_t next = 0;
    while (next < patch_.size()) {
        for_neighbours(patch_[next++], [&](RowIndex other) {
            if (is_unbalanced_[other] != 0 && patch_.size() < size) add(other);
        });
    }
}

void Patches::add_rings(int count, std::size_t size) {
    for (int ring = 0; ring < count && patch_.size() < size; ++ring) {
        const std::size_t before = patch_.size();
        add_ring();
        if (patch_.size() == before) break;
    }
}

void Patches::add_ring() {
    const std::size_t inside = patch_.size();
    for (std::size_t k = 0; k < inside; ++k) {
        for_neighbours(patch_[k], [&](RowIndex other) {
            if (in_patch_[other] != 0) return;
            in_patch_[other] = 1;
            patch_.push_back(other);
        });
    }
}

}  // namespace rockslope::dda
