#include "dda/solve/methods/patch_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dda/solve/methods/limited_contacts.hpp"

namespace rockslope::dda {

namespace {

/// The patches lead astray where the largest force change is over so many times that of the first iteration,
/// while they act and at their end.
constexpr double largest_growth = 100;
constexpr double largest_growth_at_end = 1;
/// The patches have also taken too long when their search for borders has looked at every contact of the step
/// so many times. That costs as much as some fifty iterations.
constexpr double visits_per_contact = 1500;
/// Most blocks of a step that is solved in one patch.
constexpr std::size_t largest_one_patch = 2000;
/// Most borders on the path of one patch: so many, and so many per contact of the step. Of 22 paths in steps
/// of 7000 contacts 20 end within 2000 borders, and the others not within 4750.
constexpr int one_patch_borders = 400;
constexpr double one_patch_borders_per_contact = 0.25;
/// Share of the largest unbalanced force above which a block is balanced in a patch. With 1e-3 instead of
/// none in the first iteration a slope of 381 blocks takes 40 % fewer patches.
constexpr double patch_share = 1e-3;
/// The share in a static step from its second iteration on: with 1e-3 the settling of 992 blocks with
/// cohesion takes 40 iterations a step instead of 17.
constexpr double later_static_share = 0.02;
/// Number of iterations in which patches whose path from the iterate does not end are left as they are. The
/// path from open contacts may end in another state than the next one, and most steps end before it is
/// needed.
constexpr int near_iterations = 2;
/// The first iteration whose patches grow where they throw more force on the blocks around them than they
/// were to balance, in a static step and in a dynamic one. In earlier iterations growing costs more than it
/// saves.
constexpr int first_growing_static = 3;
constexpr int first_growing_dynamic = 5;
constexpr double most_thrown = 1;
/// Largest unbalanced force of a block that is balanced, over the tolerance of forces. Patches leave such
/// blocks as they are.
constexpr double balanced_share = 0.5;

}  // namespace

PatchBalance::PatchBalance(const StepProblem& problem, StepContacts& contacts, Memory& memory,
                           const ThreadPool& pool)
    : p_(problem),
      trials_(contacts.trials),
      bounds_(contacts.bounds),
      memory_(memory),
      pool_(pool),
      visits_left_(visits_per_contact * static_cast<double>(problem.contacts.size() + problem.bolts.size())) {
    length_.resize(p_.rows.count());
    for (const RowIndex row : length_.indices())
        length_[row] = std::sqrt(p_.blocks.moments[p_.rows.block_of[row]].area);
    if (!p_.bolts.empty()) find_contacts_and_bolts();
}

void PatchBalance::find_contacts_and_bolts() {
    PerContact<ContactSprings> springs(p_.springs.begin(), p_.springs.end());
    for (const BoltSpring& bolt : p_.bolts) {
        springs.emplace_back();
        springs[ContactIndex(springs.size() - 1)].rows = bolt.rows;
    }
    memory_.row_contacts.find(p_.rows.count(), springs);
}

bool PatchBalance::advance(RowSpan<const Vec6> target, PerRow<Vec6>& displacement) {
    return memory_.damped_step.take(limited_step(), target, length_, trials_.tolerance(), displacement,
                                    pool_);
}

bool PatchBalance::relax(int iteration, RowSpan<Vec6> displacement) {
    limit_contacts(p_, trials_, bounds_, displacement, pool_, memory_.contacts);
    const int first_growing = p_.time.is_static() ? first_growing_static : first_growing_dynamic;
    const PatchAims aims{
        .tolerance = balanced_share * trials_.tolerance(),
        .share = p_.time.is_static() && iteration > 1 ? later_static_share : patch_share,
        .length = length_,
        .extent = next_extent(),
        .path = {starts_in(iteration), visits_left_, border_limit()},
        .most_thrown = iteration >= first_growing ? most_thrown : std::numeric_limits<double>::infinity()};
    const bool keeps_nearest = !is_one_patch_ && suits_one_patch(p_);
    if (keeps_nearest) memory_.before.assign(displacement.begin(), displacement.end());
    const Relaxation taken = memory_.patches.relax(limited_step(), aims, displacement, pool_);
    visits_left_ -= taken.visits;
    if (aims.extent == PatchExtent::wide) progress_.restart();
    progress_.note(taken.unbalanced);
    if (iteration == 0) began_balanced_ = true;
    exact_path_failed_ = is_one_patch_ && taken.failed > 0;
    if (keeps_nearest && taken.unbalanced < least_unbalanced_) {
        least_unbalanced_ = taken.unbalanced;
        nearest_.swap(memory_.before);
    }
    return taken.patches > 0;
}

PathStarts PatchBalance::starts_in(int iteration) const {
    if (is_one_patch_) return PathStarts::iterate_then_crossed_apart;
    return iteration > near_iterations ? PathStarts::iterate_then_apart : PathStarts::iterate;
}

int PatchBalance::border_limit() const {
    if (!is_one_patch_) return PathAims().border_limit;
    return one_patch_borders +
           static_cast<int>(one_patch_borders_per_contact * static_cast<double>(p_.contacts.size()));
}

void PatchBalance::join_all() {
    is_one_patch_ = true;
    visits_left_ = std::numeric_limits<double>::infinity();
}

bool PatchBalance::suits_one_patch(const StepProblem& problem) {
    const bool has_lines_of_segments = problem.segments.count() > 0;
    return !problem.time.is_static() && !has_lines_of_segments && problem.rows.count() <= largest_one_patch;
}

/// Where small patches stall, a path through more blocks ends that. In a static step hardly a path of so many
/// blocks ends: 190 of 194 did not in one of 9844 blocks.
PatchExtent PatchBalance::next_extent() const {
    if (is_one_patch_) return PatchExtent::all_blocks;
    if (p_.time.is_static()) return PatchExtent::two_rings;
    return progress_.has_stalled() ? PatchExtent::wide : PatchExtent::two_rings;
}

bool PatchBalance::is_complete(RowSpan<const Vec6> displacement) {
    memory_.forces.evaluate(limited_step(), displacement, length_, pool_);
    double largest = 0;
    for (const RowIndex row : length_.indices())
        largest = std::max(largest, memory_.forces.unbalanced(row).cwiseAbs().maxCoeff());
    if (!(largest <= balanced_share * trials_.tolerance())) return false;
    set_linear_forces();
    return true;
}

void PatchBalance::set_linear_forces() {
    const auto forces_of = [&](std::size_t k) {
        const LimitedContact& contact = memory_.contacts[ContactIndex(k)];
        const ElasticForces& elastic = memory_.forces.elastic()[ContactIndex(k)];
        const Vec2 forces = contact.on(contact.piece_at(elastic)).at(elastic);
        return contact.may_close ? Forces{forces.x(), forces.y()} : Forces{};
    };
    for (std::size_t k = 0; k < trials_.count(); ++k)
        trials_.set_linear_forces(ContactIndex(k), forces_of(k));
    for (std::size_t bolt = 0; bolt < p_.bolts.size(); ++bolt)
        trials_.bolts().set_linear_force(bolt, forces_of(trials_.count() + bolt).shear);
}

bool PatchBalance::threw_a_block(RowSpan<const Vec6> displacement) const {
    const PerBlock<Vec6> all = p_.rows.of_all_blocks(p_.prescribed, displacement);
    return !(largest_displacement(p_.blocks, p_.model.topology, all, pool_) <= p_.displacement_limit);
}

bool PatchBalance::leads_astray(int iteration, double force_change) {
    if (visits_left_ <= 0) return true;
    if (is_one_patch_) return exact_path_failed_ || iteration == iterations || !std::isfinite(force_change);
    if (iteration == 1) first_force_change_ = force_change;
    if (iteration == 2 && began_balanced_) first_force_change_ = std::max(first_force_change_, force_change);
    if (iteration == iterations && suits_one_patch(p_)) return true;
    const double growth = iteration == iterations ? largest_growth_at_end : largest_growth;
    return !(force_change <= growth * first_force_change_);
}

}  // namespace rockslope::dda
