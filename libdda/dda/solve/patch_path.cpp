#include "dda/solve/patch_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rockslope::dda {

namespace {

/// Changes of the matrix after which it is factorised anew.
constexpr std::size_t change_limit = 40;
/// Most borders on a path, and the least lambda: a path beyond them is given up.
constexpr int border_limit = 400;
constexpr double lowest_lambda = -20;

constexpr std::size_t no_contact = std::numeric_limits<std::size_t>::max();
/// Marks in local_row_: not in the patch; in it, but not yet met.
constexpr int outside = -1;
constexpr int unmet = -2;

}  // namespace

/// The path of Eq. (99).
PatchPath::Outcome PatchPath::follow(const LimitedStep& step, std::span<const RowIndex> rows,
                                     LimitedIterate iterate) {
    step_ = &step;
    local_row_.resize(step.base.stiffness.size(), outside);
    order(rows);
    find_contacts(iterate);
    find_unbalanced(iterate.displacement);
    Outcome outcome;
    moved_.assign(rows_.size(), Vec6::Zero());
    int sense = find_direction();
    double lambda = 0;
    while (sense != 0 && outcome.borders < border_limit) {
        Border border;
        const std::size_t contact = next_border(sense, border);
        const double remaining = sense > 0 ? 1 - lambda : std::numeric_limits<double>::infinity();
        if (border.distance >= remaining) {
            outcome.balanced = std::isfinite(remaining);
            if (outcome.balanced) move(remaining);
            break;
        }
        move(sense * border.distance);
        lambda += sense * border.distance;
        if (!(lambda >= lowest_lambda)) break;
        ++outcome.borders;
        const double pivot = cross(contact, border);
        if (pivot == 0 || !std::isfinite(pivot)) break;
        if (pivot < 0) sense = -sense;
        if (change_count_ == change_limit && find_direction() == 0) break;
    }
    if (outcome.balanced) store(iterate);
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
    if (pair.first.exists()) local.first = local_row_[pair.first];
    if (pair.second.exists()) local.second = local_row_[pair.second];
    local.opening_first = project(limited.opening, pair.first_arm);
    local.opening_second = -project(limited.opening, pair.second_arm);
    local.shearing_first = project(limited.shearing, pair.first_arm);
    local.shearing_second = -project(limited.shearing, pair.second_arm);
    local.at = iterate.elastic[contact];
    local.piece = limited.piece_at(local.at);
    contacts_.push_back(local);
    start_.push_back(local.at);
}

void PatchPath::add_forces(const Local& local, const Vec2& forces, std::span<Vec6> unbalanced) {
    if (local.first >= 0)
        unbalanced[local.first] += forces.y() * local.shearing_first - forces.x() * local.opening_first;
    if (local.second >= 0)
        unbalanced[local.second] += forces.y() * local.shearing_second - forces.x() * local.opening_second;
}

void PatchPath::find_unbalanced(RowSpan<const Vec6> displacement) {
    unbalanced_.resize(rows_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k)
        unbalanced_[k] =
            step_->base.stiffness[rows_[k]] * displacement[rows_[k]] - step_->base.load[rows_[k]];
    for (const Local& local : contacts_)
        add_forces(local, limited(local).on(local.piece).at(local.at), unbalanced_);
}

// --- the path

int PatchPath::find_direction() {
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
    const int sign = factors_.factorize();
    if (sign == 0) return 0;
    direction_.resize(rows_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) direction_[k] = -unbalanced_[k];
    solve(direction_);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Local& local = contacts_[i];
        const ElasticForces moved = change_of(local, moved_);
        local.at = {start_[i].normal + moved.normal, start_[i].shear + moved.shear};
        local.rate = change_of(local, direction_);
    }
    return sign;
}

void PatchPath::add_springs(const Local& local) {
    const Eigen::Matrix2d slope = limited(local).on(local.piece).slope;
    if (slope.isZero(0)) return;
    const auto add = [&](int row, const Vec6& opening, const Vec6& shearing) {
        if (row < 0) return;
        const Vec6 by_normal = slope(1, 0) * shearing - slope(0, 0) * opening;
        const Vec6 by_shear = slope(1, 1) * shearing - slope(0, 1) * opening;
        const auto add_column = [&](int column, const Vec6& opening_there, const Vec6& shearing_there) {
            if (column < 0) return;
            const Mat6 part = by_normal * (-limited(local).normal_stiffness * opening_there).transpose() +
                              by_shear * (limited(local).shear_stiffness * shearing_there).transpose();
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
    return {-limited(local).normal_stiffness * opening, limited(local).shear_stiffness * shearing};
}

std::size_t PatchPath::next_border(int sense, Border& border) const {
    border.distance = std::numeric_limits<double>::infinity();
    std::size_t next = no_contact;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Local& local = contacts_[i];
        const ElasticForces rate{sense * local.rate.normal, sense * local.rate.shear};
        const Border found = limited(local).first_border(local.piece, local.at, rate);
        if (found.distance >= border.distance) continue;
        border = found;
        next = i;
    }
    return next;
}

void PatchPath::move(double distance) {
    for (std::size_t k = 0; k < moved_.size(); ++k) moved_[k] += distance * direction_[k];
    for (Local& local : contacts_) {
        local.at.normal += distance * local.rate.normal;
        local.at.shear += distance * local.rate.shear;
    }
}

double PatchPath::cross(std::size_t contact, const Border& border) {
    Local& crossing = contacts_[contact];
    const LimitedContact& laws = limited(crossing);
    const Eigen::Matrix2d difference = laws.on(border.beyond).slope - laws.on(crossing.piece).slope;
    if (changes_.size() == change_count_) changes_.emplace_back();
    Change& change = changes_[change_count_];
    change.contact = contact;
    change.normal = border.normal;
    change.response.assign(rows_.size(), Vec6::Zero());
    add_forces(crossing, difference * border.normal / border.normal.squaredNorm(), change.response);
    solve(change.response);
    change.pivot = 1 + border.normal.dot(change_of(crossing, change.response).vector());
    ++change_count_;
    crossing.piece = border.beyond;
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

}  // namespace rockslope::dda
