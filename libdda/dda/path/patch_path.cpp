#include "dda/path/patch_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rockslope::dda {

namespace {

/// Changes of the matrix after which it is factorised anew.
constexpr std::size_t change_limit = 40;
/// The least lambda of any path: below it the path is given up.
constexpr double lowest_lambda = -20;
/// Most contacts of a patch in which a path begins with all of them open, and most borders on it per contact.
constexpr std::size_t apart_limit = 500;
constexpr int apart_borders_per_contact = 5;
/// Most paths in a patch that begin with those contacts open whose borders were crossed before.
constexpr int crossed_rounds = 2;
/// Unbalanced forces at the end of a path, as a share of the loads, above which they are from rounding on a
/// way of ill-conditioned matrices, and are removed.
constexpr double rounding_share = 1e-9;
/// A gap is so much wider, as a share, than needed: no contact begins on the border between open and closed.
constexpr double gap_margin = 1e-9;

constexpr std::size_t no_contact = std::numeric_limits<std::size_t>::max();
/// Marks in local_row_: not in the patch; in it, but not yet met.
constexpr int outside = -1;
constexpr int unmet = -2;

/// Whether a contact opens under enough tension; bolts and bonds without a limit do not.
bool may_open(const LimitedContact& contact) {
    return contact.normal_stiffness > 0 && std::isfinite(contact.least_normal);
}

}  // namespace

PatchPath::Outcome PatchPath::follow(const LimitedStep& step, std::span<const RowIndex> rows,
                                     LimitedIterate iterate, const PathAims& aims) {
    step_ = &step;
    visits_left_ = aims.visit_limit;
    border_limit_ = aims.border_limit;
    local_row_.resize(step.base.stiffness.size(), outside);
    order(rows);
    find_contacts(iterate);
    Outcome outcome = follow_from_starts(iterate, aims.starts);
    if (outcome.balanced) {
        remove_rounding(iterate);
        outcome.thrown = largest_thrown();
        store(iterate);
    }
    for (const RowIndex row : rows_) local_row_[row] = outside;
    return outcome;
}

// --- the patch

/// Orders the blocks by their distance from one at the rim: the submatrices then are close to the diagonal.
void PatchPath::order(std::span<const RowIndex> rows) {
    rows_.clear();
    for (const RowIndex row : rows) local_row_[row] = unmet;
    for (const RowIndex row : rows) {
        if (local_row_[row] != unmet) continue;
        met_.clear();
        walk_from(row, met_);
        for (const RowIndex each : met_) local_row_[each] = unmet;
        walk_from(met_.back(), rows_);
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) local_row_[rows_[k]] = static_cast<int>(k);
}

void PatchPath::walk_from(RowIndex root, std::vector<RowIndex>& met) {
    std::size_t next = met.size();
    met.push_back(root);
    local_row_[root] = 0;
    for (; next < met.size(); ++next) {
        const RowIndex row = met[next];
        for (const ContactIndex contact : step_->row_contacts.of(row)) {
            const BlockPair& pair = *step_->contacts[contact].rows;
            const RowIndex other = pair.first == row ? pair.second : pair.first;
            if (!other.exists() || local_row_[other] != unmet) continue;
            local_row_[other] = 0;
            met.push_back(other);
        }
    }
}

void PatchPath::find_contacts(const LimitedIterate& iterate) {
    contacts_.clear();
    start_.clear();
    for (const RowIndex row : rows_) {
        for (const ContactIndex contact : step_->row_contacts.of(row)) {
            const LimitedContact& limited = step_->contacts[contact];
            const RowIndex other = limited.rows->first == row ? limited.rows->second : limited.rows->first;
            const bool is_second_visit =
                other.exists() && local_row_[other] >= 0 && local_row_[other] < local_row_[row];
            if (limited.may_close && !is_second_visit) add_contact(contact, iterate);
        }
    }
}

void PatchPath::add_contact(ContactIndex contact, const LimitedIterate& iterate) {
    const LimitedContact& limited = step_->contacts[contact];
    const BlockPair& pair = *limited.rows;
    Local local;
    local.contact = contact;
    local.law = &limited;
    if (pair.first.exists()) local.first = local_row_[pair.first];
    if (pair.second.exists()) local.second = local_row_[pair.second];
    local.at_rim = (pair.first.exists() && local.first < 0) || (pair.second.exists() && local.second < 0);
    local.opening_first = project(limited.opening, pair.first_arm);
    local.opening_second = -project(limited.opening, pair.second_arm);
    local.shearing_first = project(limited.shearing, pair.first_arm);
    local.shearing_second = -project(limited.shearing, pair.second_arm);
    contacts_.push_back(local);
    start_.push_back(iterate.elastic[contact]);
}

void PatchPath::add_forces(const Local& local, const Vec2& forces, std::span<Vec6> unbalanced) {
    if (local.first >= 0)
        unbalanced[local.first] += forces.y() * local.shearing_first - forces.x() * local.opening_first;
    if (local.second >= 0)
        unbalanced[local.second] += forces.y() * local.shearing_second - forces.x() * local.opening_second;
}

void PatchPath::begin(RowSpan<const Vec6> displacement) {
    lambda_ = 0;
    away_ = 0;
    find_elastic_forces();
    unbalanced_.resize(rows_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const Vec6 here = displacement[rows_[k]] + moved_[k];
        unbalanced_[k] = step_->base.stiffness[rows_[k]] * here - step_->base.load[rows_[k]];
    }
    for (Local& local : contacts_) {
        add_forces(local, local.law->on(local.piece).at(local.at), unbalanced_);
        local.borders = local.law->borders(local.piece);
        local.first_piece = local.piece;
    }
}

// --- the path

PatchPath::Outcome PatchPath::follow_from_starts(const LimitedIterate& iterate, PathStarts starts) {
    Outcome outcome = follow_from_iterate(iterate);
    if (outcome.balanced || starts == PathStarts::iterate) return outcome;
    if (starts == PathStarts::iterate_then_apart) {
        if (contacts_.size() > apart_limit) return outcome;
        for (Local& local : contacts_) local.is_apart = may_open(*local.law);
        outcome += follow_from_apart(iterate, apart_borders_per_contact * static_cast<int>(contacts_.size()));
        return outcome;
    }
    for (int round = 0; round < crossed_rounds && !outcome.balanced; ++round) {
        for (Local& local : contacts_) local.is_apart = local.crossed && may_open(*local.law);
        outcome += follow_from_apart(iterate, border_limit_);
    }
    return outcome;
}

/// An open contact without cohesion bears the same in several pieces.
bool PatchPath::is_away(const Local& local, const Piece& piece) {
    return !(local.law->on(piece) == local.law->on(local.first_piece));
}

/// The path of Eq. (99).
PatchPath::Outcome PatchPath::follow_from_iterate(const LimitedIterate& iterate) {
    moved_.assign(rows_.size(), Vec6::Zero());
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        contacts_[i].approach = 0;
        contacts_[i].piece = contacts_[i].law->piece_at(start_[i]);
    }
    begin(iterate.displacement);
    return walk(border_limit_);
}

/// The path of Eq. (100).
PatchPath::Outcome PatchPath::follow_from_apart(const LimitedIterate& iterate, int most_borders) {
    hold_open();
    Outcome outcome = follow_from_iterate(iterate);
    release(iterate);
    if (!outcome.balanced) return outcome;
    set_gap();
    begin(iterate.displacement);
    outcome += walk(most_borders);
    outcome.began_apart = true;
    return outcome;
}

void PatchPath::hold_open() {
    open_laws_.resize(contacts_.size());
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        if (!contacts_[i].is_apart) continue;
        open_laws_[i] = *contacts_[i].law;
        open_laws_[i].normal_stiffness = 0;
        start_[i].normal = open_laws_[i].least_normal;
        contacts_[i].law = &open_laws_[i];
    }
}

void PatchPath::release(const LimitedIterate& iterate) {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        contacts_[i].law = &step_->contacts[contacts_[i].contact];
        start_[i] = iterate.elastic[contacts_[i].contact];
    }
}

void PatchPath::set_gap() {
    double gap = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const LimitedContact& law = *contacts_[i].law;
        if (!contacts_[i].is_apart) continue;
        const double normal = start_[i].normal + change_of(contacts_[i], moved_).normal;
        gap = std::max(gap, (normal - law.least_normal) / law.normal_stiffness);
    }
    for (Local& local : contacts_)
        if (local.is_apart) local.approach = (1 + gap_margin) * gap * local.law->normal_stiffness;
}

void PatchPath::remove_rounding(const LimitedIterate& iterate) {
    for (Local& local : contacts_) local.approach = 0;
    begin(iterate.displacement);
    double largest = 0, load = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        largest = std::max(largest, unbalanced_[k].cwiseAbs().maxCoeff());
        load = std::max(load, step_->base.load[rows_[k]].cwiseAbs().maxCoeff());
    }
    if (largest <= rounding_share * load || find_direction() == 0) return;
    Border border;
    next_border(1, border);
    if (border.distance >= 1) move(1);
}

PatchPath::Outcome PatchPath::walk(int most_borders) {
    Outcome outcome;
    int sense = find_direction();
    while (sense != 0 && outcome.borders < most_borders && visits_left_ > 0) {
        outcome.visits += static_cast<double>(contacts_.size());
        visits_left_ -= static_cast<double>(contacts_.size());
        Border border;
        const std::size_t contact = next_border(sense, border);
        const double remaining = sense > 0 ? 1 - lambda_ : std::numeric_limits<double>::infinity();
        if (border.distance >= remaining) {
            outcome.balanced = std::isfinite(remaining);
            if (outcome.balanced) move(remaining);
            break;
        }
        const double before = lambda_;
        move(sense * border.distance);
        const bool came_back = outcome.borders > 0 && away_ == 0 && (before > 0) != (lambda_ > 0);
        if (!(lambda_ >= lowest_lambda) || came_back) break;
        ++outcome.borders;
        const double pivot = cross(contact, border);
        if (pivot == 0 || !std::isfinite(pivot)) break;
        if (pivot < 0) sense = -sense;
        if (change_count_ == change_limit && find_direction() == 0) break;
    }
    return outcome;
}

int PatchPath::find_direction() {
    const int sign = factorize();
    if (sign == 0) return 0;
    direction_.resize(rows_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) direction_[k] = -unbalanced_[k];
    for (const Local& local : contacts_)
        add_forces(local, -local.approach * local.law->on(local.piece).slope.col(0), direction_);
    solve(direction_);
    find_elastic_forces();
    for (Local& local : contacts_) {
        local.rate = change_of(local, direction_);
        local.rate.normal += local.approach;
    }
    return sign;
}

void PatchPath::find_elastic_forces() {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Local& local = contacts_[i];
        local.at = start_[i] + change_of(local, moved_);
        local.at.normal -= (1 - lambda_) * local.approach;
    }
}

int PatchPath::factorize() {
    last_.resize(rows_.size());
    for (std::size_t k = 0; k < last_.size(); ++k) last_[k] = static_cast<int>(k);
    for (const Local& local : contacts_) {
        if (local.first < 0 || local.second < 0) continue;
        const auto [low, high] = std::minmax(local.first, local.second);
        last_[low] = std::max(last_[low], high);
    }
    for (std::size_t k = 1; k < last_.size(); ++k) last_[k] = std::max(last_[k], last_[k - 1]);
    factors_.reset(last_);
    for (std::size_t k = 0; k < rows_.size(); ++k)
        factors_.add(static_cast<int>(k), static_cast<int>(k), step_->base.stiffness[rows_[k]]);
    for (const Local& local : contacts_) add_springs(local);
    change_count_ = 0;
    return factors_.factorize();
}

void PatchPath::add_springs(const Local& local) {
    const Eigen::Matrix2d slope = local.law->on(local.piece).slope;
    if (slope.isZero(0)) return;
    const auto add = [&](int row, const Vec6& opening, const Vec6& shearing) {
        if (row < 0) return;
        const Vec6 by_normal = slope(1, 0) * shearing - slope(0, 0) * opening;
        const Vec6 by_shear = slope(1, 1) * shearing - slope(0, 1) * opening;
        const auto add_column = [&](int column, const Vec6& opening_there, const Vec6& shearing_there) {
            if (column < 0) return;
            const Mat6 part = by_normal * (-local.law->normal_stiffness * opening_there).transpose() +
                              by_shear * (local.law->shear_stiffness * shearing_there).transpose();
            factors_.add(row, column, part);
        };
        add_column(local.first, local.opening_first, local.shearing_first);
        add_column(local.second, local.opening_second, local.shearing_second);
    };
    add(local.first, local.opening_first, local.shearing_first);
    add(local.second, local.opening_second, local.shearing_second);
}

/// The factors, then each change by Sherman and Morrison's formula.
void PatchPath::solve(std::span<Vec6> x) const {
    factors_.solve(x);
    for (std::size_t c = 0; c < change_count_; ++c) {
        const Change& change = changes_[c];
        const ElasticForces by = change_of(contacts_[change.contact], x);
        const double part = change.normal.dot(by.vector()) / change.pivot;
        for (std::size_t k = 0; k < x.size(); ++k) x[k] -= part * change.response[k];
    }
}

ElasticForces PatchPath::change_of(const Local& local, std::span<const Vec6> x) const {
    double opening = 0, shearing = 0;
    if (local.first >= 0) {
        opening += local.opening_first.dot(x[local.first]);
        shearing += local.shearing_first.dot(x[local.first]);
    }
    if (local.second >= 0) {
        opening += local.opening_second.dot(x[local.second]);
        shearing += local.shearing_second.dot(x[local.second]);
    }
    return {-local.law->normal_stiffness * opening, local.law->shear_stiffness * shearing};
}

std::size_t PatchPath::next_border(int sense, Border& border) const {
    const auto along = [&](const Local& local) {
        return ElasticForces{sense * local.rate.normal, sense * local.rate.shear};
    };
    double least = std::numeric_limits<double>::infinity();
    std::size_t next = no_contact;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Local& local = contacts_[i];
        const double distance = local.borders.distances(local.at, along(local)).minCoeff();
        if (distance >= least) continue;
        least = distance;
        next = i;
    }
    border.distance = least;
    if (next == no_contact) return next;
    const Local& local = contacts_[next];
    border = local.law->first_border(local.piece, local.at, along(local));
    return next;
}

void PatchPath::move(double distance) {
    lambda_ += distance;
    for (std::size_t k = 0; k < moved_.size(); ++k) moved_[k] += distance * direction_[k];
    for (Local& local : contacts_) {
        local.at.normal += distance * local.rate.normal;
        local.at.shear += distance * local.rate.shear;
    }
}

double PatchPath::cross(std::size_t contact, const Border& border) {
    Local& crossing = contacts_[contact];
    const Eigen::Matrix2d difference =
        crossing.law->on(border.beyond).slope - crossing.law->on(crossing.piece).slope;
    if (changes_.size() == change_count_) changes_.emplace_back();
    Change& change = changes_[change_count_];
    change.contact = contact;
    change.normal = border.normal;
    change.response.assign(rows_.size(), Vec6::Zero());
    add_forces(crossing, difference * border.normal / border.normal.squaredNorm(), change.response);
    solve(change.response);
    change.pivot = 1 + border.normal.dot(change_of(crossing, change.response).vector());
    ++change_count_;
    crossing.crossed = true;
    away_ += (is_away(crossing, border.beyond) ? 1 : 0) - (is_away(crossing, crossing.piece) ? 1 : 0);
    crossing.piece = border.beyond;
    crossing.borders = crossing.law->borders(crossing.piece);
    const double part = border.normal.dot(crossing.rate.vector()) / change.pivot;
    for (std::size_t k = 0; k < direction_.size(); ++k) direction_[k] -= part * change.response[k];
    for (Local& local : contacts_) {
        const ElasticForces by = change_of(local, change.response);
        local.rate.normal -= part * by.normal;
        local.rate.shear -= part * by.shear;
    }
    return change.pivot;
}

void PatchPath::store(LimitedIterate iterate) const {
    for (std::size_t k = 0; k < rows_.size(); ++k) iterate.displacement[rows_[k]] += moved_[k];
    for (const Local& local : contacts_) iterate.elastic[local.contact] = local.at;
}

double PatchPath::largest_thrown() const {
    double largest = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Local& local = contacts_[i];
        if (!local.at_rim) continue;
        const Vec2 before = local.law->on(local.law->piece_at(start_[i])).at(start_[i]);
        const Vec2 after = local.law->on(local.piece).at(local.at);
        largest = std::max(largest, (after - before).cwiseAbs().maxCoeff());
    }
    return largest;
}

}  // namespace rockslope::dda
