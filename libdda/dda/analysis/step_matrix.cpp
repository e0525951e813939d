#include "dda/analysis/step_matrix.hpp"

#include <algorithm>

namespace dda {

StepMatrix::StepMatrix(const StepProblem& problem, const BlockPattern& pattern, BlockMatrix& work,
                       const Crew& crew)
    : p_(problem),
      pattern_(pattern),
      matrix_(work),
      crew_(crew),
      contacts_(problem.springs.size()),
      moved_(problem.springs.size()),
      bolts_(problem.bolts.size()) {}

void StepMatrix::assemble(const TrialContacts& trials) {
    take_springs(trials);
    take_bolts(trials);
    matrix_.diagonal.resize(p_.base.stiffness.size());
    matrix_.upper.resize(pattern_.columns.size());
    crew_.for_ranges(p_.base.stiffness.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            if (is_changed(static_cast<int>(row))) put_together(row);
        }
    });
    for (std::size_t k = 0; k < bolts_.size(); ++k) {
        if (bolts_[k] != 0) add_bolt(p_.bolts[k], bolts_[k]);
    }
    assembled_ = true;
}

StepMatrix::Springs StepMatrix::springs_of(const TrialContacts& trials, std::size_t contact) const {
    return {trials.is_pressed(contact) ? trials.normal_stiffness(contact) : 0,
            trials.is_locked(contact) ? p_.springs[contact].shear_stiffness : 0};
}

double StepMatrix::stiffness_of_bolt(const TrialContacts& trials, std::size_t bolt) const {
    return trials.is_elastic(bolt) ? p_.bolts[bolt].stiffness : 0;
}

void StepMatrix::take_springs(const TrialContacts& trials) {
    crew_.for_ranges(contacts_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Springs now = springs_of(trials, k);
            moved_[k] = now != contacts_[k] ? 1 : 0;
            contacts_[k] = now;
        }
    });
    if (!assembled_) return;
    changed_.resize(p_.base.stiffness.size());
    crew_.for_ranges(changed_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const std::span<const int> contacts = p_.row_contacts.of(row);
            changed_[row] = std::any_of(contacts.begin(), contacts.end(),
                                        [&](int k) { return moved_[static_cast<std::size_t>(k)] != 0; })
                                ? 1
                                : 0;
        }
    });
}

void StepMatrix::take_bolts(const TrialContacts& trials) {
    for (std::size_t k = 0; k < bolts_.size(); ++k) {
        const double now = stiffness_of_bolt(trials, k);
        const PairRows& rows = p_.bolts[k].rows;
        for (const int row : {rows.first, rows.second}) {
            if (assembled_ && now != bolts_[k] && row >= 0) changed_[static_cast<std::size_t>(row)] = 1;
        }
        bolts_[k] = now;
    }
}

void StepMatrix::put_together(std::size_t row) {
    const int r = static_cast<int>(row);
    matrix_.diagonal[row] = p_.base.stiffness[row];
    for (int k = pattern_.start[row]; k < pattern_.start[row + 1]; ++k) {
        const auto place = static_cast<std::size_t>(k);
        if (is_changed(pattern_.columns[place])) matrix_.upper[place].setZero();
    }
    int other = -1;  // row of the last contact's other block, which is that of the next few, too
    Mat6* beside = nullptr;
    for (const int contact : p_.row_contacts.of(row)) {
        const auto k = static_cast<std::size_t>(contact);
        const ContactSprings& s = p_.springs[k];
        const int others = s.rows.first == r ? s.rows.second : s.rows.first;
        if (others != other) {
            other = others;
            beside = other > r && is_changed(other)
                         ? &matrix_.upper[static_cast<std::size_t>(pattern_.position(r, other))]
                         : nullptr;
        }
        const auto add = [&](const Vec2& direction, double stiffness) {
            if (stiffness == 0) return;
            const Vec6 gradient = s.rows.of_row(r, direction);
            const Vec6 force = stiffness * gradient;
            matrix_.diagonal[row].noalias() += force * gradient.transpose();
            if (beside != nullptr) beside->noalias() += force * s.rows.of_row(other, direction).transpose();
        };
        add(s.normal.direction, contacts_[k].normal);
        add(s.shear.direction, contacts_[k].shear);
    }
}

void StepMatrix::add_bolt(const BoltSpring& bolt, double stiffness) {
    const PairRows& rows = bolt.rows;
    const bool first = is_changed(rows.first);
    const bool second = is_changed(rows.second);
    const Vec6 of_first = rows.of_first(bolt.elongation);
    const Vec6 of_second = rows.of_second(bolt.elongation);
    if (first) matrix_.add_square(rows.first, of_first, stiffness);
    if (second) matrix_.add_square(rows.second, of_second, stiffness);
    if (first && second && rows.first != rows.second)
        matrix_.add_outer(pattern_, rows.first, rows.second, stiffness * of_first, of_second);
}

}  // namespace dda
